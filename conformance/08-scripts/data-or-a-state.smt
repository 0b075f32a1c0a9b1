spec 8.54  [data] is the section of a state of that name.

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
[data]
.step
    out = b
    seen = x + y + n
-- app.ss --
[options]
delta_t 10
[data]
G == 0: x = 5
G == 10 { @assert x == 5
  @stop }
