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
1 G 0
1 S 1
1 T 0
1 open true
2 G 10
2 S 1
2 T 10
2 open true
3 G 20
3 S 1
3 T 20
3 open true
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 1
  T = 20
  open = true
