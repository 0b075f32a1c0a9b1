# A trace on standard output, before the report.
args test --trace=- a.sm a.ss

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
G == 20 {
    @assert open
    @stop
}
-- stdout --
script,step,G,state,T,open
a.ss,1,0,Idle,0,1
a.ss,2,10,Idle,10,1
a.ss,3,20,Idle,20,1
-- stderr --
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
