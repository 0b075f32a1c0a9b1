spec 8.68  delta_t file needs [data].
expect error

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
bool b @read_only
U8 n @read_only
bool out
F64 seen
[Run]
.step
    out = b
    seen = x + y + n
-- app.ss --
[options]
delta_t file   #! E0778 no [data]
[all_states]
true: @stop
