spec 5.22, 5.23  States are numbered from 1 in the order of the file, and the first one begins.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Zulu]
.step -> Mike
[Alpha]
.step -> Bravo
[Mike]
.step -> Alpha
[Bravo]
.step x = 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert S == 1
G == 1: @assert S == 3
G == 2: @assert S == 2
G == 3: @assert S == 4
G == 3: @stop
