# What is not in the trace is reported: cases, scripts that did not run; and names that a column cannot have.
args test --trace=t.csv a.sm a.ss bad.ss cases; cat t.csv
args test --trace=u.csv a.sm bad.ss; ls
args test --trace=- --trace-elements=S a.sm long.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool step
F64 state
[Idle]
.step
    step = state > 1
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0 {
    @assert not step
    @stop
}
-- long.ss --
[options]
delta_t 3000000000000001
[all_states]
G > 14000000000000000 {
    @assert not step
    @stop
}
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 0: nosuch = 1
G == 0: @stop
-- cases/one.smt --
\-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- stdout --
2 passed, 1 failed
script,step,G,state,T,a.state,a.step
a.ss,1,0,Idle,0,0,0
a.sm
a.ss
bad.ss
cases
long.ss
t.csv
script,step,G,state,S
long.ss,1,0,Idle,1
long.ss,2,3000000000000001,Idle,1
long.ss,3,6000000000000002,Idle,1
long.ss,4,9000000000000003,Idle,1
long.ss,5,12000000000000004,Idle,1
long.ss,6,15000000000000005,Idle,1
-- stderr --
smc: the trace has the scripts of 'a.sm'; cases are not traced
bad.ss:4:9: error: unknown element 'nosuch' [E0204]
    4 | G == 0: nosuch = 1
      |         ^~~~~~
1 error
smc: bad.ss did not run and is not in the trace
bad.ss:4:9: error: unknown element 'nosuch' [E0204]
    4 | G == 0: nosuch = 1
      |         ^~~~~~
1 error
smc: bad.ss did not run and is not in the trace
smc: no script ran: there is nothing to write to 'u.csv'
state script ran for 6 steps
1 assert passed
final state vector:
  G = 15000000000000005
  S = 1
  T = 15000000000000005
  state = 0.000000
  step = false
smc: 'G' has values in the trace that a double cannot represent: spreadsheets round them
