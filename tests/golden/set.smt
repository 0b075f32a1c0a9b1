# The parameters of an image are listed and set; what is refused has the words of scripts, of 'smc test --set' and of errors.
args build a.sm -g
args set a.smb
args set a.smb limit=300 gain=0.2 on=false offset=-5 -o b.smb
args set b.smb
args verify b.smb
args set b.smb n=+0x9 a.limit=4.5e2 -o c.smb
args set c.smb
args set a.smb limit=1200 limit=149.9 limit=nan limit=12m n=2.5 on=2 count=1 b.limit=300 -o d.smb
args set a.smb limit=300
args set a.smb limit -o d.smb
args set a.smb =3 -o d.smb
args set -o d.smb
args set a.sm
args set a.smb n=4 -o a.smb
args key k.key
args sign b.smb --key=k.key --number=1
args set b.smb limit=200 -o d.smb
args set b.smb
args build --emit=bytecode a.sm e.sm -o two.smb
args set two.smb
args set two.smb gain=0.5 2.limit=7 -o two2.smb
args set two2.smb
args set two.smb limit=200 -o d.smb
args test a.sm a.ss --set n=2 --set=limit=999
args test a.sm a.ss --set=n=2.5 --set=nothing=1
args test a.sm a.ss --set=n
args test --set=n=3
args test . --set=n=3

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 limit = 450 @parameter @range 150 1000
F32 gain = 0.1 @parameter @range -1.5 1.5
I16 offset = -3 @parameter @range -5 5
U8 n = 3 @parameter @range 1 9
bool on = true @parameter
F64 count = 0
[Run] @safe
.step
    count = count + 1
    x = limit * gain + offset + n + on + count
-- e.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 limit = 5 @parameter @range 1 10
[Run] @safe
.step
    x = limit
-- a.ss --
[options]
delta_t 1
set limit 200
[all_states]
G == 0: @print limit, n
G == 0: @stop
-- stdout --
logic e1e0d621986f3b9a, settings 1f95e14b409358fe
limit = 450 (F64, 150 to 1000, default 450)
gain = 0.1 (F32, -1.5 to 1.5, default 0.1)
offset = -3 (I16, -5 to 5, default -3)
n = 3 (U8, 1 to 9, default 3)
on = true (bool, default true)
logic e1e0d621986f3b9a, settings da1113b32f25f4e0
limit = 300 (F64, 150 to 1000, default 450)
gain = 0.2 (F32, -1.5 to 1.5, default 0.1)
offset = -5 (I16, -5 to 5, default -3)
n = 3 (U8, 1 to 9, default 3)
on = false (bool, default true)
b.smb: machine 1: 1 state, longest step 16 instructions, 120 bytes of RAM on a 64-bit computer, state vector 24 bytes (layout c7de1feb)
logic e1e0d621986f3b9a, settings 10b859f5c03628e0
limit = 450 (F64, 150 to 1000, default 450)
gain = 0.2 (F32, -1.5 to 1.5, default 0.1)
offset = -5 (I16, -5 to 5, default -3)
n = 9 (U8, 1 to 9, default 3)
on = false (bool, default true)
k.key: key [..]
logic e1e0d621986f3b9a, settings da1113b32f25f4e0
limit = 300 (F64, 150 to 1000, default 450)
gain = 0.2 (F32, -1.5 to 1.5, default 0.1)
offset = -5 (I16, -5 to 5, default -3)
n = 3 (U8, 1 to 9, default 3)
on = false (bool, default true)
logic 16ff8e0afd91df8f, settings 8adcbeff64680b10
1.limit = 450 (F64, 150 to 1000, default 450)
1.gain = 0.1 (F32, -1.5 to 1.5, default 0.1)
1.offset = -3 (I16, -5 to 5, default -3)
1.n = 3 (U8, 1 to 9, default 3)
1.on = true (bool, default true)
2.limit = 5 (F64, 1 to 10, default 5)
logic 16ff8e0afd91df8f, settings 1c399c05da8250fd
1.limit = 450 (F64, 150 to 1000, default 450)
1.gain = 0.5 (F32, -1.5 to 1.5, default 0.1)
1.offset = -3 (I16, -5 to 5, default -3)
1.n = 3 (U8, 1 to 9, default 3)
1.on = true (bool, default true)
2.limit = 7 (F64, 1 to 10, default 5)
step 1 (G = 0): limit = 999, n = 2
state script ran for 1 step
0 asserts passed
final state vector:
  G = 0
  S = 1
  T = 0
  count = 1.000000
  gain = 0.100000
  limit = 999.000000
  n = 2
  offset = -3
  on = true
  x = 100.900001
-- stderr --
smc: cannot set parameter 'limit' to 1200: the value is above the range
smc: cannot set parameter 'limit' to 149.9: the value is below the range
smc: cannot set parameter 'limit' to nan: the value is not a number
smc: cannot set parameter 'limit' to 12m: the value is not a number
smc: cannot set parameter 'n' to 2.5: the value of an integer must be a whole number
smc: cannot set parameter 'on' to 2: the value of a bool must be 0 or 1
smc: cannot set parameter 'count' to 1: the machine has no such parameter
smc: cannot set parameter 'b.limit' to 300: the machine has no such parameter
smc: set requires an image; to set parameters also their values and -o, as in 'smc set tank.smb limit=40 -o flight.smb'
Try 'smc set --help'.
smc: expected the name of a parameter and its value, as in limit=40, not 'limit'
Try 'smc set --help'.
smc: expected the name of a parameter and its value, as in limit=40, not '=3'
Try 'smc set --help'.
smc: set requires an image; to set parameters also their values and -o, as in 'smc set tank.smb limit=40 -o flight.smb'
Try 'smc set --help'.
smc: a.sm: refused, because rule 1 is violated at byte 0: an image begins with the bytes 's' 'm' 'b'
smc: it is no image; 'smc build' makes one of a machine
smc: 'a.smb' is an input of this command and cannot be its output; name another file after -o
Try 'smc set --help'.
smc: b.smb is signed: set its parameters before 'smc sign', because the code covers their values
smc: several machines of the image have a parameter 'limit': name the machine, as in MACHINE.limit=40
a.ss:6:9: warning: the script has no @assert, @expect or @fail: it tests only that @stop is reached [W0751 script-without-assert]
    6 | G == 0: @stop
      |         ^~~~~
1 warning
smc: cannot set parameter 'n' to 2.5: the value of an integer must be a whole number
smc: cannot set parameter 'nothing' to 1: the machine has no such parameter
smc: expected the name of a parameter and its value, as in limit=40, not 'n'
Try 'smc test --help'.
smc: name what to test: a machine and a script, as in 'smc test tank.sm tank.ss', or .smt cases
Try 'smc test --help'.
smc: --set requires a machine and scripts; a case sets parameters in [options] of its script
Try 'smc test --help'.
-- exit --
0 0 0 0 0 0 0 1 2 1 1 2 1 2 0 0 1 0 0 0 0 0 1 0 1 2 2 2
