# Every engine that can be named; all but c are always there.
args test --engine=ref a.sm a.ss
args test --engine vm a.sm a.ss
args test --engine vm-soft a.sm a.ss
args test --engine=warp a.sm a.ss

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
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
-- stderr --
smc: --engine is ref, vm, vm-soft, c, c-soft or all, not 'warp'
Try 'smc test --help'.
-- exit --
0 0 0 2
