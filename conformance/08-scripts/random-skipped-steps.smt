spec 8.51   The value of a call depends on seed, call and step alone: steps in which it is not evaluated make no difference.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p @read_only
[A]
.step
    x = p
-- always.ss --
[options]
delta_t 10
[all_states]
true: p = random(0, 1)
at 0: @assert p == 0.060026863822713494
at 30: @assert p == 0.6042418936267495
at 50: @assert p == 0.35615443950518966
at 50: @stop
-- seldom.ss --
[options]
delta_t 10
[all_states]
G == 0 or G == 30 or G == 50: p = random(0, 1)
at 0: @assert p == 0.060026863822713494
at 30: @assert p == 0.6042418936267495
at 50: @assert p == 0.35615443950518966
at 50: @stop
-- once.ss --
[options]
delta_t 10
[all_states]
G >= 50: p = random(0, 1)
at 50: @assert p == 0.35615443950518966
at 50: @stop
