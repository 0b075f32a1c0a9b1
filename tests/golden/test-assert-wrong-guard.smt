# An assert whose guard has an error: only the error is reported.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool out
[A] @safe
.step
    out = x > 5
-- a.ss --
[options]
delta_t 10
[all_states]
at 90 and x > 9: @assert out
at 30: @stop
-- stderr --
a.ss:4:1: error: 'at 90' is a whole condition and cannot be part of another one [E0759]
    4 | at 90 and x > 9: @assert out
      | ^~~~~ write G == 90
1 error
-- exit --
1
