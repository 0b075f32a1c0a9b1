# What is reported in an included file names the script, also where recorded data or [options] are included, and what the check reports.
args test a.sm t1.ss
args test a.sm t2.ss 2>&1 >/dev/null | head -n 4
args test a.sm t3.ss 2>&1 >/dev/null | head -n 4
args test --message-format=json a.sm t4.ss t5.ss 2>&1 >/dev/null | grep -o 'message.*' | cut -d, -f 1-3,7-10
args check a.sm t6.ss t7.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
bool out
[A] @safe
.step
    out = x > 5
    x > 10: -> B
[B]
.step
    out = false
-- d.csv --
t,x,out
0,1,0
20,9,0
10,9,1
30,9,1
-- data.ss --
[data]
file "d.csv"
time "t" ms
x = "x"
@compare out "out"
-- rows.ss --
[options]
delta_t file
-- long.ss --
[options]
delta_t 9223372036854775808
-- cells.csv --
t,x
0,1
10,a
-- cells.ss --
[data]
file "cells.csv"
time "t" ms
x = "x"
-- none.ss --
[data]
file "none.csv"
time "t" ms
x = "x"
-- at.ss --
[all_states]
at 30: @assert out
-- t1.ss --
include "data.ss"
[options]
delta_t 10
[all_states]
at 40: @stop
-- t2.ss --
include "rows.ss"
include "data.ss"
[B]
true: @stop
-- t3.ss --
include "long.ss"
[B]
true: @stop
-- t4.ss --
include "cells.ss"
[options]
delta_t 10
[all_states]
at 40: @assert not out
at 40: @stop
-- t5.ss --
include "none.ss"
[options]
delta_t 10
[all_states]
at 40: @assert not out
at 40: @stop
-- t6.ss --
include "at.ss"
[options]
delta_t 10
[all_states]
at 40: @stop
-- t7.ss --
include "at.ss"
[options]
delta_t 20
[all_states]
at 40: @stop
-- stdout --
rows.ss:2:9: error: the data ended at G = 30 before the script reached @stop [E0780]
    2 | delta_t file
      |         ^~~~
t2.ss:1:9: note: the script that ran includes it here
long.ss:2:9: error: G would overflow after step 2: it cannot advance by delta_t again [E0752]
    2 | delta_t 9223372036854775808
      |         ^~~~~~~~~~~~~~~~~~~
t3.ss:1:9: note: the script that ran includes it here
message":"cells.csv:3: 'a' is not a number","file":"cells.ss","line":4,"label":null,"notes":[{"message":"the script that ran includes it here","file":"t4.ss","line":1
message":"none.csv: No such file or directory","file":"none.ss","line":2,"label":null,"notes":[{"message":"the script includes it here","file":"t5.ss","line":1
-- stderr --
data.ss:3:6: warning: 1 of 4 rows are skipped, because their time is missing or not later than in the row before; the first is d.csv:4 [W0770 data-times]
    3 | time "t" ms
      |      ^~~
t1.ss:1:9: note: the script that ran includes it here
data.ss:5:14: error: 'out' differs from column 'out' in 1 of 5 steps [E0781]
    5 | @compare out "out"
      |              ^~~~~ first at G = 20, row 2 (d.csv:3): true, recorded false
t1.ss:1:9: note: the script that ran includes it here
note: they differ at G = 20
1 error, 1 warning
at.ss:2:1: error: no step has G = 30: G advances by 20 ms [E0757]
    2 | at 30: @assert out
      | ^~~~~ the nearest are 20 ms and 40 ms
t7.ss:1:9: note: the script includes it here
1 error
-- exit --
1 0 0 0 1
