# smc why: held through a definition, as a condition and as an operand, is 0 or 1, and says for how long its condition was true.
args why a.sm a.ss --at 90ms

-- a.sm --
[options]
time_unit ms
step 10
[state_vector]
U64 G
U32 S
F64 p1
F64 p2
F64 limit
bool out
[define]
far1 = held(abs(p1 - p2) > 2, 5 steps)
slow = held(p1 > limit, 400 ms)
[A]
.step
 out = 3 - far1 > 2
 slow: -> B
 far1: -> B
[B]

-- a.ss --
[options]
delta_t 10 ms
[all_states]
true: p1 = 30
true: limit = 28
G < 60 ms: p2 = 30
else: p2 = 10
at 90 ms: @assert out
at 90 ms: @stop

-- stdout --
step 10 (G = 90): A, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:16: `out = 3 - far1 > 2` stored true: 3 - far1 = 3, far1 = 0
  a.sm:17: `slow` was false since step 1 (G = 0); its condition was true since G = 0, for 90 of 400
  a.sm:18: `far1` was false since step 1 (G = 0); its condition was true for 4 of 5 steps
where the values come from:
  a.ss:4: the script wrote p1 in step 10, by `p1 = 30`
  a.ss:5: the script wrote limit in step 10, by `limit = 28`
  a.ss:7: the script wrote p2 in step 10, by `p2 = 10`
