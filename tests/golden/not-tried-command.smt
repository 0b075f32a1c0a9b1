# A guard that is evaluated only in steps that leave its state: the note does not say that a free command was never given.
args check -Wno-all -Wnot-tried a.sm

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time  @alias G
U32  state @alias S
F64  x     @read_only @range -10 10
F64  y     @read_only @range -10 10
bool arm   @read_only @command

[Wake] @safe
.step
    T >= 50 ms {
        arm and (x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001 and x + y > 7.02 and held(x > 2, 20 ms): -> Target
        -> Pad
    }

[Pad] @safe
.step
    arm: -> Wake

[Target] @safe
.step
    T > 1 s: -> Pad
-- stderr --
a.sm:11:2: warning: trial runs have not tried everything: no run reached 'Target'; not every failure of 'x' was tried in 'Wake'; not every failure of 'y' was tried in 'Wake' [W0930 not-tried]
   11 | [Wake] @safe
      |  ^~~~
a.sm:14:17: note: no run reached 'Target', because '(x - 3) * (x - 3) + (y - 4) * (y - 4) < 0.0001' was never true; the closest was (x - 3) * (x - 3) + (y - 4) * (y - 4) = 0.2523
note: trials of a state that no run reached begin with it, as if it were the first state; a script that leads there, run with 'smc faults', tries it as it is
note: a script that leads through the state, run with 'smc faults', tries failures of this sensor there
1 warning
