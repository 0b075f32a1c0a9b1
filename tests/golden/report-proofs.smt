# The page has the verdicts on requirements, if that is wanted.
args report a.sm a.rq --prove --format=text -o o.txt || sed -n "/^Proofs/,/^Traceability/p" o.txt
args report a.sm twice.rq --prove --format=text -o p.txt

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
bool armed @read_only
F64 p @read_only
bool open
[Idle]
.step
    armed: -> Fill
[Fill]
.step
    open = p > 100
    T > 50 ms: -> Idle
.exit
    open = false
-- a.rq --
R1 "closed when idle"  always S == Idle implies not open
R2 "never open"        never open
-- twice.rq --
R1 "armed"  always armed
R2 "safe"   never armed
-- stdout --
Proofs
------

`smc prove` decides whether any run can violate a requirement. A proof holds for all inputs, NaN
and infinities included, with the machine's step and the assumptions named. The lines after a proof
are what is true after each step in a state. A script shows a violation. Without a proof and
without a violation, the requirement is only as good as its tests.

R1: closed when idle [proved]
  assuming that only this machine writes the elements that it assigns
  assuming that in the first step G and the elements that the machine assigns are 0
  in Idle: open is false
  in Fill: T is at most 60

R2: never open [violated]
  after 2 steps
  # Violates R2 (never open).

  [options]
  delta_t    10 ms
  init_state Idle

  [all_states]
  at 0:     armed = true
  at 0:     @assert state Idle and not open
  at 10 ms: p = 101
  at 10 ms: @assert state Fill and open
  at 10 ms: @stop

Traceability
-- stderr --
twice.rq:2:1: error: requirement R2 contradicts R1: no step can meet both [E1312]
    2 | R2 "safe"   never armed
      | ^~
twice.rq:1:1: note: the first one is here
1 error
-- exit --
0 1
