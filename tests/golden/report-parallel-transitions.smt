# If several transitions lead from one state to another, a run does not show which was taken: the report does not claim that all were.
args report a.sm a.ss --format=text | sed -n '/^  .* covered /p; /together/p; /^Not covered/,/^a.ss/p'
args report a.sm b.ss --format=text | sed -n '/^  .* covered /p; /^Not covered/,/^b.ss/p'

-- a.sm --
[state_vector]
U64 G
U32 S
F32 x @read_only
[Idle]
.step
    x > 5: -> Done
    T > 5000: -> Done
[Done]
.step
    x > 8: -> Idle
    x < -8: -> Lost
    T > 10: -> Idle
    x == 1: -> Idle
[Lost]
-- a.ss --
[options]
delta_t 10
[all_states]
true: x = 9
[Done]
G > 1000: x = 0 - 9
[Lost]
true: @stop
-- b.ss --
[options]
delta_t 10
[all_states]
true: x = 9
G == 100: @stop
-- stdout --
  States covered       3 of 3
  Transitions covered  3 of 6
Not covered by the scripts
Nothing: the scripts visit every state and take every transition.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places       Covered  Of  Impossible
  transitions        3   6           0
  statements         6  12           0
  guards             4  12           0
  conditions         4  12           0
  states             5   5           0

  Line  Not covered
     7  `x > 5` was never false
     8  `T > 5000` was never executed
    12  `x < -8` was never false
    13  `T > 10` was never executed
    14  `x == 1` was never executed

a.ss [passed]
  States covered       2 of 3
  Transitions covered  2 of 6
Not covered by the scripts
No script visits `Lost`. No script takes a transition from `Done` to `Lost`.

Coverage
A place is one outcome that a script can show. A transition is one place for each state from which
it can be taken: one of all states is several places, but one row in the tables of transitions. A
guard and a condition are two places each, true and false. Places that no run can reach are
impossible, and are not counted.

  Places       Covered  Of  Impossible
  transitions        2   6           0
  statements         4  12           0
  guards             2  12           0
  conditions         2  12           0
  states             4   5           0

  Line  Not covered
     7  `x > 5` was never false
     8  `T > 5000` was never executed
    11  `x > 8` was never false
    12  `x < -8` was never executed
    13  `T > 10` was never executed
    14  `x == 1` was never executed
    15  state Lost was never entered

b.ss [passed]
