# A machine on standard input, tested with a script from a file.
args test - a.ss <a.sm

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
