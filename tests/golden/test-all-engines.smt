# Every engine that is here, in lock step: one report.
args test --engine=all a.sm a.ss

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
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
