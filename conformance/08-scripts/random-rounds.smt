spec 8.52  Each operation of `random` and `noise` rounds.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
bool on
[Run] @safe
.step
    on = x > y
-- app.ss --
[options]
delta_t 10
seed 148
[all_states]
true:  x = random(0.1, 0.7)
true:  y = noise(0.3)
at 0:  @assert x == 0.4781861322466284 and y == -0.29790690899826583
at 10: @assert x == 0.13045746851712464 and y == -0.29832612751051785
at 20: @assert x == 0.16506142248399558 and y == -0.19313910654745994
at 20: @stop
