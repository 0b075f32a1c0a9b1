# --trace-elements chooses the columns, by name or alias; a name that is not there is compared with those that are.
args test --trace=t.csv --trace-elements=limit,p,limit,G,S a.sm a.ss && cat t.csv
args test --trace=u.csv --trace-elements=p,oppen a.sm a.ss
args test --trace=u.csv --trace-elements=nothing_like_it a.sm a.ss
args test --trace=u.csv --trace-elements=p,,q a.sm a.ss
args test --trace-elements=p a.sm a.ss
args test --trace=u.csv cases; ls

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
F64 p @read_only
F32 q
[local]
U8 limit = 3 @read_only
I64 n = -9007199254740993
[Idle]
.step
    open = p > 5
    q = p / 10
    open: -> Busy
[Busy]
.step
    n = n + 1
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 5.1
G == 20 {
    @assert open
    @stop
}
-- cases/one.smt --
\-- a.sm --
[state_vector]
U64 G
U32 S
[A]
-- stdout --
state script ran for 3 steps
1 assert passed
final state vector:
  G = 20
  S = 2
  T = 0
  limit = 3
  n = -9007199254740991
  open = true
  p = 5.100000
  q = 0.510000
script,step,G,state,limit,p,S
a.ss,1,0,Idle,3,0,1
a.ss,2,10,Idle,3,5.1,1
a.ss,3,20,Busy,3,5.1,2
a.sm
a.ss
cases
t.csv
-- stderr --
a.sm:8:4: warning: local 'limit' is never used [W0204 unused-local]
    8 | U8 limit = 3 @read_only
      |    ^~~~~
a.sm:9:5: warning: local 'n' is read only to compute its own next value [W0206 unused-local]
    9 | I64 n = -9007199254740993
      |     ^
a.sm:9:10: warning: 9007199254740993 is too large to be exact: its value is 9007199254740992 [W0415 precision-loss]
    9 | I64 n = -9007199254740993
      |          ^~~~~~~~~~~~~~~~
3 warnings
a.sm:8:4: warning: local 'limit' is never used [W0204 unused-local]
    8 | U8 limit = 3 @read_only
      |    ^~~~~
a.sm:9:5: warning: local 'n' is read only to compute its own next value [W0206 unused-local]
    9 | I64 n = -9007199254740993
      |     ^
a.sm:9:10: warning: 9007199254740993 is too large to be exact: its value is 9007199254740992 [W0415 precision-loss]
    9 | I64 n = -9007199254740993
      |          ^~~~~~~~~~~~~~~~
3 warnings
smc: --trace-elements: the machine has no 'oppen'; did you mean 'open'?
Try 'smc test --help'.
a.sm:8:4: warning: local 'limit' is never used [W0204 unused-local]
    8 | U8 limit = 3 @read_only
      |    ^~~~~
a.sm:9:5: warning: local 'n' is read only to compute its own next value [W0206 unused-local]
    9 | I64 n = -9007199254740993
      |     ^
a.sm:9:10: warning: 9007199254740993 is too large to be exact: its value is 9007199254740992 [W0415 precision-loss]
    9 | I64 n = -9007199254740993
      |          ^~~~~~~~~~~~~~~~
3 warnings
smc: --trace-elements: the machine has no 'nothing_like_it'; it has G, S, T, limit, n, open, p, q
Try 'smc test --help'.
a.sm:8:4: warning: local 'limit' is never used [W0204 unused-local]
    8 | U8 limit = 3 @read_only
      |    ^~~~~
a.sm:9:5: warning: local 'n' is read only to compute its own next value [W0206 unused-local]
    9 | I64 n = -9007199254740993
      |     ^
a.sm:9:10: warning: 9007199254740993 is too large to be exact: its value is 9007199254740992 [W0415 precision-loss]
    9 | I64 n = -9007199254740993
      |          ^~~~~~~~~~~~~~~~
3 warnings
smc: --trace-elements requires names separated by commas, as in --trace-elements=pressure,valveOpen
Try 'smc test --help'.
smc: --trace-elements requires --trace=FILE
Try 'smc test --help'.
smc: --trace requires a machine and a script; .smt cases have a part 'trace'
Try 'smc test --help'.
-- exit --
0 2 2 2 2 0
