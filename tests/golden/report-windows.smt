# Windows that a chip has no memory for; a local that only sizes a window; a long time axis and a group of warnings as words of their own.
args report big.sm --format=text | grep 'On an Arduino \|RAM of state vector\|sizes of windows' | sed 's/  */ /g'
args report small.sm --format=text | grep 'On an Arduino \|RAM of state vector' | sed 's/  */ /g' | cut -c 1-24
args report small.sm small.ss | grep -o '>100000<\|1e+05\|<td class="b">-Wflight<' | sort -u

-- big.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 mean
[local]
U16 size = 700 @read_only
[Idle]
.step
    mean = roll_avg(p, size)
-- small.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 mean
[Idle]
.step
    mean = roll_avg(p, 200)
    T > 50000: -> Rest
[Rest]
-- small.ss --
[options]
delta_t 1000
[all_states]
true: p = G
G == 120000: @stop
-- stdout --
 On an Arduino does not fit into its memory
 size U16 700 sizes of windows 7
 RAM of state vector, locals and windows 5640 bytes of at most 5056
 On an Arduino Mega abou
On an Arduino Mega
 RAM of state vector, lo
<td class="b">-Wflight<
>100000<
