# A machine that does not compile runs no script.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stderr --
a.sm:7:5: error: unknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     ^~~~~~~~~ did you mean 'valveOpen'?
a.sm:4:6: note: 'valveOpen' is declared here
1 error
-- exit --
1
