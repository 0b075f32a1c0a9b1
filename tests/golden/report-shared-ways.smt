# Of two transitions from one state to the same other one it is not known which a run made: nothing says that both were.
args report a.sm a.ss --format=text | sed -n '/Seen by/p; /together/p; /^Where no/,/^a.ss/p'
args report a.sm b.ss --format=text | sed -n '/Seen by/p; /^Where no/,/^b.ss/p'

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
  Seen by scripts    3 of 3 states, 3 of 3 ways; of 2 it is not seen by which transition
  Idle  Done     51  2 transitions, counted together
  Done  Idle     50  3 transitions, counted together
Where no script has been
The scripts have been in every state, and have gone from each to every other it leads to.

Of transitions between the same two states it is not seen which was made: from `Idle` to `Done`
(lines 7, 8), from `Done` to `Idle` (lines 11, 13, 14). Some of them may never have been.

a.ss [passed]
  Seen by scripts    2 of 3 states, 2 of 3 ways; of 2 it is not seen by which transition
Where no script has been
Of transitions between the same two states it is not seen which was made: from `Idle` to `Done`
(lines 7, 8), from `Done` to `Idle` (lines 11, 13, 14). Some of them may never have been.

b.ss [passed]
