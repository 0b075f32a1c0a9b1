# Of an application, a question can name the machine of a state or of a variable, as scripts do.
args why x.app a.ss --to=drain.Open | head -n 1
args why x.app a.ss '-> tank.Wait' | head -n 1
args why x.app a.ss --to=drain.Wait | head -n 1
args why x.app a.ss --machine=drain --to=drain.Open | head -n 1
args why x.app a.ss tank.valve --at=70 | head -n 1
args why x.app a.ss --of=drain.valve --at=60 | head -n 1
args why x.app a.ss --machine=tank --to=drain.Open
args why x.app a.ss --to=tnk.Wait
args why x.app a.ss --to=tank.Open
args why x.app a.ss --to=tank.
args why tank.sm tank.ss --sv x.sv --to=tank.Abort

-- tank.ss --
[options]
delta_t 10
[all_states]
G == 0: pressure = 1
G == 100: @stop
-- x.sv --
[V]
U64 time
F64 pressure
bool valve
U32 tankMode
U32 drainMode
-- x.app --
[options]
state_vector "x.sv"
time time 1 ms
[start]
tankMode = 1
drainMode = 1
[flight]
every 10 ms:
    machine tank "tank.sm"
every 20 ms:
    machine drain "drain.sm"
-- tank.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 tankMode @alias S
F64 pressure @read_only
bool valve
[Wait]
.step
    valve = pressure > 8
    pressure > 12: -> Abort
[Abort] @abort @safe
-- drain.sm --
[options]
step 20 ms
[state_vector]
U64 time @alias G
U32 drainMode @alias S
F64 pressure @read_only
bool valve @read_only
[Wait]
.step
    valve and pressure > 10: -> Open
[Open]
.step
    T > 1000: -> Idle
[Idle] @safe
-- a.ss --
[all_states]
G == 0: pressure = 1
G == 30: pressure = 11
G == 40: pressure = 9.5
G == 60: pressure = 3
G == 100: @stop
-- stdout --
step 11 (G = 100): drain ran Wait, entered in step 1 (G = 0); took no transition
step 11 (G = 100): tank ran Wait, entered in step 1 (G = 0); took no transition
step 11 (G = 100): drain ran Wait, entered in step 1 (G = 0); took no transition
step 11 (G = 100): drain ran Wait, entered in step 1 (G = 0); took no transition
step 8 (G = 70): valve = false, last stored in this step
step 7 (G = 60): valve = false
-- stderr --
smc: 'drain.Open' names another machine than --machine=tank
Try 'smc why --help'.
smc: 'x.app' has no machine 'tnk'; its machines are tank, drain
Try 'smc why --help'.
smc: machine 'tank' has no state 'Open'; its states are Wait, Abort
Try 'smc why --help'.
smc: no machine of 'x.app' has the state 'tank.'
Try 'smc why --help'.
smc: machine 'tank' has no state 'tank.Abort'; its states are Wait, Abort
Try 'smc why --help'.
-- exit --
0 0 0 0 0 0 2 2 2 2 2
