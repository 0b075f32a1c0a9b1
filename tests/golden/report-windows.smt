# Windows that a chip has no memory for; a local that only sizes a window; a long time axis and a group of warnings as words of their own.
args report big.sm --format=text | grep 'On an Arduino Uno \|Windows alone\|sizes of windows' | sed 's/  */ /g'
args report small.sm --format=text | grep 'On an Arduino Uno \|Windows alone' | sed 's/  */ /g' | cut -c 1-24
args report small.sm small.ss | grep -o '>100000<\|1e+05\|<td class="b">-Wflight<' | sort -u

-- big.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 mean
[local]
U16 size = 256 @read_only
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
 On an Arduino Uno does not fit into its memory
 size U16 256 sizes of windows 7
 Windows alone more than its 2048 bytes of memory
 On an Arduino Uno about
<td class="b">-Wflight<
>100000<
