spec 1.29  Code may stand on the line of a section header and of a label.

-- app.sm --
[state_vector] U64 G U32 S F64 x F64 y
[local] F64 k = 4
[Run] .entry x = 1
.step y = k

-- app.ss --
[options] delta_t 1
[all_states] G == 0: @assert x == 1 and y == 4
G == 0: @stop
