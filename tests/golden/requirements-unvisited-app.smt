# In an application, the states that no script came to have the names of their machines.
args test x.app x.ss x.rq -w | grep '^  R\|no script'

-- x.app --
[options]
state_vector "v.sv"
time         time 1 ms

[loop]
every 10 ms:
    machine one "m.sm" { go = goOne  state = stateOne }
    machine two "m.sm" { go = goTwo  state = stateTwo }
-- v.sv --
[Time]
U64  time
[All]
U32  stateOne
U32  stateTwo
bool goOne
bool goTwo
-- m.sm --
[state_vector]
U64  time   @alias G
U32  state  @alias S
bool go     @read_only
[Idle]
.step
    go: -> Run
[Run]
.step
    not go: -> Idle
-- x.rq --
R1 "first"  never two.Run before one.Run
R2 "both"   always one.S == Run or two.S == Idle implies not goTwo
-- x.ss --
[all_states]
at 50 ms: goOne = true
at 100 ms: @assert one.S == Run
at 100 ms: @stop
-- stdout --
  R1  never judged  first
      no script came to two.Run
  R2  met           both
