# --trace writes a row of CSV for each step of each script, with the state by its name; numbers read back as they were.
args test --trace=t.csv a.sm a.ss '"b,c".ss' && cat t.csv

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
-- "b,c".ss --
[options]
delta_t 1
[all_states]
G == 0: p = 1/3
G == 1: p = -0.0
G == 2: p = 5e-324
G == 3: p = 1 / 0
G == 4: p = 123456789
G == 4: @assert open
G == 4: @stop
-- stdout --
2 passed, 0 failed
script,step,G,state,T,n,open,p,q
a.ss,1,0,Idle,0,-9007199254740992,0,0,0
a.ss,2,10,Idle,10,-9007199254740992,1,5.1,0.5099999904632568
a.ss,3,20,Busy,0,-9007199254740991,1,5.1,0.5099999904632568
"""b,c"".ss",1,0,Idle,0,-9007199254740992,0,0.3333333333333333,0.03333333507180214
"""b,c"".ss",2,1,Idle,1,-9007199254740992,0,-0.0,-0.0
"""b,c"".ss",3,2,Idle,2,-9007199254740992,0,5e-324,0
"""b,c"".ss",4,3,Idle,3,-9007199254740992,1,inf,inf
"""b,c"".ss",5,4,Busy,0,-9007199254740991,1,123456789,inf
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
