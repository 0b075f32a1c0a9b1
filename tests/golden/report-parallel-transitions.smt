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
  Transitions covered  3 to 6 of 6
  Idle  Done     51  2 transitions, counted together
  Done  Idle     50  3 transitions, counted together
Not covered by the scripts
The scripts visit every state and go from each state to every state to which its transitions lead.

If several transitions lead from one state to another, a run does not show which of them was taken:
from `Idle` to `Done` (lines 7, 8), from `Done` to `Idle` (lines 11, 13, 14). Some of them may
never have been taken.

a.ss [passed]
  States covered       2 of 3
  Transitions covered  2 to 5 of 6
Not covered by the scripts
No script visits `Lost`. No script takes a transition from `Done` to `Lost`.

If several transitions lead from one state to another, a run does not show which of them was taken:
from `Idle` to `Done` (lines 7, 8), from `Done` to `Idle` (lines 11, 13, 14). Some of them may
never have been taken.

b.ss [passed]
