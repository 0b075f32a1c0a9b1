spec 8.69  Rows between two steps are counted.
warn no-data-times

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
bool b @read_only
U8 n @read_only
bool out
F64 seen
[Run]
.step
    out = b
    seen = x + y + n
-- d.csv --
t,P
0,1
1,2
2,3
10,4
10.5,5
10.5,6
19,7
20,8
21,9
-- report --
state script ran for 3 steps
0 asserts passed
d.csv: 9 rows read, 1 of them skipped (the first is line 7), 4 between two steps
final state vector:
  G = 20
  S = 1
  T = 20
  b = false
  n = 0
  out = false
  seen = 8.000000
  x = 8.000000
  y = 0.000000
-- app.ss --
[options]
delta_t 10
[data]
file "d.csv"
time "t" ms
x = "P"
[all_states]
G == 20: @stop
