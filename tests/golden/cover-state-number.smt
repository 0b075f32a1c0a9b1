# In the code of a state, S has its number if no code outside the machine writes it.
args cover a.sm -o made | grep -v '^wrote'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  G
U32  S
F64  p @read_only
bool spark
bool vent

[all_states]
.step
    spark = S == Burn and p > 3
    vent = S == Idle and not spark

[Idle]
.step
    S == Burn: -> Done
    p > 9: -> Burn
.exit
    S != Idle: vent = true

[Burn]
.entry
    S == Idle: vent = true
.step
    not spark and p > 2: -> Done

[Done] @safe
-- stdout --
goals of a: 43 of 43 reached, and 11 impossible
impossible:
  line 14: `spark` was never true while it decided: it is never true, if only inputs change
  line 18: `S == Burn` was never true: `S` is always 1, if only inputs change
  line 21: `S != Idle` was never true: `S` is always 1, if only inputs change
  line 25: `S == Idle` was never true: `S` is always 2, if only inputs change
  7 more goals, with the same cause as one of these
