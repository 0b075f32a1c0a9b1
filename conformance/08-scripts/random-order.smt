spec 8.50  Calls are numbered in the order of the text, those in definitions first, whatever a step evaluates.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
seed 42
[all_states]
G < 0: p = random(0, 1)
[define]
first = random(0, 4294967296)
second = random(0, 4294967296) + 0 * first
[all_states]
at 0: @assert first == 1307692281 and second == 4286966985
at 0: @assert random(0, 4294967296) == 206217550
at 10: @stop
