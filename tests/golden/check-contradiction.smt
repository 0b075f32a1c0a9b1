# smc check reports two requirements that no step can meet together, in one file or in two.
args check a.sm a.rq
args check a.sm b.rq a.rq
args check a.sm a.ss b.rq
args check x.app a.rq

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
[Idle] @safe
.step
    valve = p > 800
-- a.ss --
[options]
delta_t 10
[all_states]
at 0: @assert not valve
at 0: @stop
-- v.sv --
[All]
U64 G
U32 S
F64 p
bool valve
-- x.app --
[options]
state_vector "v.sv"
time         G 1 ms
[loop]
every 10 ms:
    machine a "a.sm"
-- a.rq --
R1 "vent opens" always p > 800 implies valve
R2 "no other"   never  p < 0
R3 "vent stays" always p > 800 implies not valve
-- b.rq --
R4 "vacuum"     never  p > 0
R5 "tank"       always p > 900 implies p > 10
R6 "idle"       always not valve
-- stderr --
a.rq:3:1: error: requirement R3 contradicts R1: no step can meet both [E1312]
    3 | R3 "vent stays" always p > 800 implies not valve
      | ^~
a.rq:1:1: note: the first one is here
1 error
b.rq:2:1: warning: requirement R5 is never violated, whatever the machine does [W1304 decided-requirement]
    2 | R5 "tank"       always p > 900 implies p > 10
      | ^~
a.rq:3:1: error: requirement R3 contradicts R1: no step can meet both [E1312]
    3 | R3 "vent stays" always p > 800 implies not valve
      | ^~
a.rq:1:1: note: the first one is here
1 error, 1 warning
b.rq:2:1: warning: requirement R5 is never violated, whatever the machine does [W1304 decided-requirement]
    2 | R5 "tank"       always p > 900 implies p > 10
      | ^~
1 warning
-- exit --
1 1 0 0
