# A script that writes a read-only local: it is no constant in this test, and that is reported.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[local]
U8 limit = 5 @read_only
[Idle]
.step
    open = limit > 6
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: limit = 7
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
  limit = 7
  open = true
-- stderr --
a.ss:4:9: warning: the script assigns 'limit', a @read_only local, which is therefore not a constant in this test [W0701 script-writes-constant]
    4 | G == 0: limit = 7
      |         ^~~~~
a.sm:6:4: note: 'limit' is declared here
1 warning
