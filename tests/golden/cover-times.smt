# smc cover proves with how long a state lasts at most: until its limit, and at most delta_t longer.
args cover a.sm -o made | grep -v '^wrote'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F32 level @read_only @range 0 100

[Fill] @safe
.step
    level > 90 and T >= 200 ms: -> Full
    T > 210 ms: -> Drain                       # the next line ends the state before
    T > 190 ms: -> Drain

[Full] @safe
.step
    level < 10 and T > 500 ms: -> Fill

[Drain] @safe
.step
    level < 10: -> Fill
-- stdout --
goals of a: 41 of 41 reached, and 4 impossible
impossible:
  line 12: `T > 210 ms` was never true: `T` is from 0 to 200, if only inputs change, and delta_t is 10
  3 more goals, with the same cause as one of these
