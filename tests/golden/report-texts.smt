# A report lists the asserts that have a text or a requirement, with their results.
args report a.sm a.ss --format=text | sed -n "/^Scripts/,/^What it costs/p" | sed -n "/a.ss/,\$p"

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
[Idle]
.step
    open = p > 5
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 7.5
G == 10: @expect open within 20 ms "the valve opens" @req R7
G == 20: @print p + 1, open "the level & more"
G == 20: @print S
G == 30: @assert open @req R7
G == 300: @fail "never at 30 < 40" @req R9
G == 40: @stop
-- stdout --
  a.ss    passed      5               2  1 of 1

States visited by the scripts
  State  Times entered  Steps  Scripts
  Idle               1      5        1

Not covered by the scripts
Nothing: the scripts visit every state and take every transition.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places      Covered  Of  Impossible
  statements        1   1           0
  guards            2   2           0
  conditions        2   2           0
  states            1   1           0

a.ss [passed]
  Line    Text              Requirement  Result
  a.ss:5  the valve opens   R7           met
  a.ss:8                    R7           met
  a.ss:9  never at 30 < 40  R9           not reached

  step 3 (G = 20), the level & more: p + 1 = 8.5, open = true
  step 3 (G = 20): S = Idle, number 1

  Step  G  State entered  Duration
     1  0  Idle           until the end

What it costs
