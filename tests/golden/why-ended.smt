# How a run ended that neither stopped nor failed at an assert: recorded values differ, the data ended, or G cannot advance.
args why a.sm differs.ss | head -n 2
args why a.sm ended.ss | head -n 2
args why a.sm over.ss | head -n 2
args why a.sm wrong.ss 2>/dev/null | head -n 2
args report a.sm ended.ss --format=text 2>/dev/null | grep "ended.ss  failed"

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool on
[A] @safe
.step
    on = x > 5
    x > 10: -> B
[B] @safe
-- d.csv --
t,x,on,y
0,7,1,1
10,7,0,1
20,3,0,a
-- differs.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "x"
@compare on "on"
[all_states]
at 20: @stop
-- ended.ss --
[options]
delta_t file
[data]
file "d.csv"
time "t" ms
x = "x"
[B]
true: @stop
-- over.ss --
[options]
delta_t 9223372036854775808
[B]
true: @stop
-- wrong.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "y"
[all_states]
at 20: @stop
-- stdout --
step 3 (G = 20): A, entered in step 1 (G = 0); took no transition
the script failed: 'on' differed from column 'on' in 1 of 3 steps, first at G = 10, at differs.ss:7
step 3 (G = 20): A, entered in step 1 (G = 0); took no transition
the recorded data ended before the script stopped
step 2 (G = 9223372036854775808): A, entered in step 1 (G = 0); took no transition
the script did not stop before the end of G
step 1 (G = 0): A, entered in step 1 (G = 0); took no transition
the recorded data cannot be read further
  ended.ss  failed: the recorded data ended      3               0  1 of 2
