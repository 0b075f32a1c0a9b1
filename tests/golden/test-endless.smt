# A script that does not reach @stop is given up.
args test --max-steps=2 a.sm a.ss

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
-- stderr --
a.ss:5:13: warning: this assert was never evaluated [W0750 unjudged-assert]
    5 |     @assert open
      |             ^~~~ its condition was never true
a.ss:6:5: error: the script did not reach @stop within 2 steps [E0751]
    6 |     @stop
      |     ^~~~~
a.ss:6:5: note: this condition was evaluated in every step and was never true
note: the machine has been in state 'Idle' from the start
note: the last steps, and the values after each:
      step   G  state
         1   0  Idle
         2  10  Idle
1 error, 1 warning
-- exit --
1
