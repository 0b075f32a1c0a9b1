spec 1.27  A statement ends at the end of its line, before a brace, a label, a section header and the end of the file.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 d
F64 e

[Run]
.entry a = 1 .step
    b = 2
    if b == 2 { c = 3 } .exit d = 4 [Next] .entry e = 5
-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert a == 1 and b == 2 and c == 3 and d == 0
G == 0: @stop
