# A step that is estimated at more cycles of an ATmega328P than --max-cycles allows is an error with the state and its dearest lines.
args build a.sm --max-cycles=5000
args build a.sm --max-cycles=90000
args check b.sm --max-cycles=5000

-- a.sm --
[state_vector]
U64 G
U32 S
F64 speed
F64 pressure @read_only
[Flow] @safe
.step
    speed = sqrt(pressure)
-- b.sm --
[state_vector]
U64 G
U32 S
U16 n
[Count] @safe
.step
    n = n + 1
-- stderr --
a.sm:6:2: error: a step of machine 'a' in state 'Flow' is estimated at up to [..] cycles, but --max-cycles allows 5000 [E0862]
    6 | [Flow] @safe
      |  ^~~~
a.sm:8:5: note: [..] of them are for this line
1 error
-- exit --
1 0 0
