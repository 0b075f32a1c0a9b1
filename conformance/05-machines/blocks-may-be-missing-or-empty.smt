spec 5.26  Missing and empty blocks do nothing.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.entry
.step
    x = x + 1
    T == 1: -> B
.exit

[B]

[C]
.entry
.exit
.step

-- app.ss --
[options]
delta_t 1

[all_states]
G == 5: @assert S == 2 and x == 2
G == 5: @stop
