# What smc prove refuses: requirements of another machine, requirements that contradict each other, and wrong arguments.
args prove a.sm other.rq
args prove a.sm contradict.rq
args prove a.sm
args prove a.rq
args prove a.sm a.csv a.rq
args prove a.sm a.rq --init-state=Flying
args prove a.sm a.rq --step=20
args prove a.sm a.rq two.rq --requirements=R1,R2,R3
args prove a.sm a.rq two.rq --requirements=
args test a.sm a.ss a.rq --prove

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only @range 0 500
bool arm    @read_only
bool valve
U8   count

[Idle] @safe
.entry
    valve = false
.step
    arm: -> Fill

[Fill]
.entry
    valve = true
    count = 0
.step
    held(p > 100, 50 ms) or T >= 2 s: -> Hold
    p > 900: -> Never
.exit
    valve = false

[Hold]
.step
    count = count + 1
    count >= 3: -> Idle

[Never] @safe
-- a.rq --
R1 "closed outside of filling"   never S != Fill and valve
-- two.rq --
R2 "closed at the end"           never S == Never and valve
-- a.ss --
[options]
delta_t 10
-- other.rq --
R1 "no pyro on the pad"          never S == Pad and drogue
-- contradict.rq --
R1 "closed"                      always S == Hold implies not valve
R2 "count"                       never count > 3
R3 "open"                        always S == Hold implies valve and count < 2
-- stderr --
other.rq:1:45: error: unknown state 'Pad' [E0501]
    1 | R1 "no pyro on the pad"          never S == Pad and drogue
      |                                             ^~~
note: 'a.sm' has none of the names that these requirements use; are they for another machine?
other.rq:1:53: error: unknown element 'drogue' [E0204]
    1 | R1 "no pyro on the pad"          never S == Pad and drogue
      |                                                     ^~~~~~
2 errors
contradict.rq:3:1: error: requirement R3 contradicts R1: no step can meet both [E1312]
    3 | R3 "open"                        always S == Hold implies valve and count < 2
      | ^~
contradict.rq:1:1: note: the first one is here
1 error
smc: requirements are required, as in 'smc prove M.sm R.rq'
Try 'smc prove --help'.
smc: prove requires a machine, as in 'smc prove tank.sm'
Try 'smc prove --help'.
smc: 'a.csv' is neither a machine (.sm) nor requirements (.rq) nor a script (.ss)
Try 'smc prove --help'.
smc: --init-state: the machine has no state 'Flying'
Try 'smc prove --help'.
a.sm:2:6: error: --step is 20, but the machine declares a step of 10 [E0706]
    2 | step 10 ms
      |      ^~~~~
1 error
smc: --requirements: there is no requirement 'R3'; the files have R1, R2
smc: option '--requirements' has an empty LIST
Try 'smc prove --help'.
smc: --prove requires --traceability
Try 'smc test --help'.
-- exit --
1 1 2 2 2 2 1 2 2 2
