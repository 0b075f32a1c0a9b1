spec 8.43  A number on the following line does not belong to such a word.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
bool at
[A]
.step
    at: p = p + 1
-- app.ss --
[options]
delta_t 10
[all_states]
at              #! E0327
20: p = 1
G == 40: @stop
