# smc faults: what is refused, and inputs that leave nothing to do.
args faults a.sm
args faults a.app a.ss
args faults a.sm bad.ss
args faults a.sm broken.ss
args faults a.sm a.ss --kinds=dead,broken
args faults a.sm a.ss --inputs=q
args faults a.sm a.ss --inputs=G
args faults a.sm a.ss --offset=0
args faults a.sm a.ss --late=0
args faults a.sm a.ss --at=soon
args faults a.sm a.ss --at=9999
args faults a.sm a.ss --at='1 s',2s --kinds=dead
args faults a.sm a.ss --at='0.5 q'
args faults a.sm a.ss --at=0.5
args faults a.sm a.ss --fail-on=none
args faults a.sm a.ss --max-runs=0
args faults a.sm a.ss --kinds=flipped
args faults a.sm a.ss --max-runs=3 | head -n 1
args faults none.sm none.ss
args faults a.sm a.ss --seed=x
args faults a.sm a.ss -MD
args faults a.sm a.ss --scripts=kept; cat kept/001-p-stuck.ss

-- a.app --
[options]
state_vector "a.sv"

[main]
every 10 ms:
    machine a "a.sm"

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open
[Fill]
.step
    open = p > 100
-- a.ss --
[options]
delta_t 10
[all_states]
true: p = G
at 300: @assert open
at 300: @stop
-- kept/001-p-stuck.ss --
my own script
-- bad.ss --
[options]
delta_t 10
[all_states]
true: @assert open
at 300: @stop
-- broken.ss --
[options]
delta_t 10
[all_states]
true: q = 1
at 300: @stop
-- none.sm --
[state_vector]
U64 G
U32 S
bool open
[Fill]
.step
    open = T > 100
-- none.ss --
[options]
delta_t 10
[all_states]
at 300: @assert open
at 300: @stop
-- stdout --
faults of a: 1 input, 0 triggers in 1 script; 0 of 0 faults have an effect
input  stuck  dead  nan  low  high  below  above  noisy  late  dropped
p      -      -     -    -    -     -      -      -      -     -
note: 'p' has no @range; its range in the runs without a fault is 0 to 300
faults of a: 1 input, 0 triggers in 1 script; 0 of 0 faults have an effect
input  dead
p      -
note: 'p' has no @range; its range in the runs without a fault is 0 to 300
faults of a: 1 input, 2 triggers in 1 script; 0 of 0 faults have an effect
input
p
note: 'p' has no @range; its range in the runs without a fault is 0 to 300
faults of a: 1 input, 2 triggers in 1 script; 3 of 3 faults have an effect
faults of none: 0 inputs, 2 triggers in 1 script; 0 of 0 faults have an effect
my own script
-- stderr --
smc: faults requires a script to run, as in 'smc faults a.sm SCRIPT.ss'
Try 'smc faults --help'.
a.app:2:14: error: cannot read 'a.sv': No such file or directory [E1031]
    2 | state_vector "a.sv"
      |              ^~~~~~
a.app:6:13: error: machine 'a' needs the time: in [options], time ELEMENT 1 ms [E1030]
    6 |     machine a "a.sm"
      |             ^
a.app:6:15: error: two files would have the name 'a.c': the state vector 'a.sv' and a machine 'a.sm' [E1043]
    6 |     machine a "a.sm"
      |               ^~~~~~
a.app:2:14: note: the first one is here
3 errors
smc: bad.ss fails at bad.ss:4 without any fault, and no other script is left: correct it or the machine ('smc test' shows why), or name a script that passes
broken.ss:4:7: error: unknown element 'q' [E0204]
    4 | true: q = 1
      |       ^
1 error
smc: --kinds is a list of stuck, dead, nan, low, high, below, above, noisy, late, dropped and flipped, not 'broken'
Try 'smc faults --help'.
smc: 'a' has no element 'q' that can be faulty: name an element of the state vector, but not its time or its state
smc: 'a' has no element 'G' that can be faulty: name an element of the state vector, but not its time or its state
smc: --offset requires a percentage above 0 and up to 100, not '0'
Try 'smc faults --help'.
smc: --late requires a number of steps from 1 to 10000, not '0'
Try 'smc faults --help'.
smc: --at requires a time, as in 400, '4 s' or 250ms, not 'soon'
Try 'smc faults --help'.
smc: warning: no script reaches a time of --at, so no fault begins
smc: warning: no script reaches a time of --at, so no fault begins
smc: --at requires a time, as in 400, '4 s' or 250ms, not '0.5 q'
Try 'smc faults --help'.
smc: --at: '0.5' is no whole number of ms, in which G counts
Try 'smc faults --help'.
smc: --fail-on is aborted, differs, endless, elsewhere, failed or violated, not 'none'
Try 'smc faults --help'.
smc: --max-runs requires a whole number from 1, not '0'
Try 'smc faults --help'.
smc: warning: no input can have a fault of --kinds=flipped, so no fault begins: smc faults --help says which inputs have which
smc: faults under "failed" (3) fail asserts, which describe a flight without faults: write what must hold with any fault as requirements, in a .rq file
smc: stopped after 3 runs: --max-runs allows no more, so faults are missing
smc: warning: the machine has no input: it reads no element that a script writes or that is '@read_only'
smc: --seed requires a whole number from 0 to 9007199254740992, not 'x'
Try 'smc faults --help'.
smc: standard output has no name that -MD can derive a name from: name the rule's file with -MF
Try 'smc faults --help'.
smc: 'kept/001-p-stuck.ss' is the name of a source, and only 'smc fix' writes to sources; name another folder with --scripts
Try 'smc faults --help'.
-- exit --
2 1 1 1 2 1 1 2 2 2 0 0 2 2 2 2 0 0 0 2 2 0
