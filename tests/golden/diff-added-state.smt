# A state without statements that is added or removed is one change, and nothing of it is in another order.
args diff a.sm b.sm
args diff b.sm a.sm

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool go
[Idle] @safe
.step
    go: -> Run
[Run]
.step
    not go: -> Idle
-- b.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool go
[Idle] @safe
.step
    go: -> Run
[Run]
.step
    not go: -> Done
[Done] @safe
-- stdout --
comparison of a.sm with b.sm: behaviour changed: 2 changes
behaviour:
  ~ Run: -> Done changed
      - not go
      + not go
      leads to Done instead of Idle
  + Done: state added
      + Done @safe
costs:
  bytes of the image: 90, now 93
swap without stopping: possible in Idle
comparison of b.sm with a.sm: behaviour changed: 2 changes
behaviour:
  - Done: state removed
      - Done @safe
  ~ Run: -> Idle changed
      - not go
      + not go
      leads to Idle instead of Done
costs:
  bytes of the image: 93, now 90
swap without stopping: possible in Idle; not in Done
-- exit --
1 1
