# A script is checked with its machine.
args check a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20: @stop
shut: open = false
-- stderr --
a.ss:5:1: error: unknown element 'shut' [E0204]
    5 | shut: open = false
      | ^~~~
1 error
-- exit --
1
