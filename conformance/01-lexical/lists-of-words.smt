spec 1.32  In regions, [state_vector] and [options] line ends are blanks, and entries may share a line.

-- app.sv --
[options] lock [R] U64
G U32 S F64

# comment
x F64 y

-- app.sm --
[state_vector] U64 G U32
S @read_only F64
x
@read_only
@alias
pressure
F64 y
[Run] .step y = pressure

-- app.ss --
[options] delta_t
# ten
10
init_state
Run delta_t 5
[all_states] G == 0: x = 3
G == 5: @assert y == 3
G == 5: @stop
