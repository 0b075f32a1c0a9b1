# --trace-format=exact has every value after every step, to the last bit, of one script.
args test --trace=t.txt --trace-format=exact a.sm a.ss >/dev/null && cat t.txt
args test --trace=t.txt --trace-format=exact a.sm a.ss '"b,c".ss'
args test --trace=t.txt --trace-format=exact --trace-elements=p a.sm a.ss
args test --trace=t.txt --trace-format=json a.sm a.ss

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
1 G 0
1 S 1
1 T 0
1 limit 3
1 n -9007199254740992
1 open false
1 p 0x0p+0
1 q 0x0p+0
2 G 10
2 S 1
2 T 10
2 limit 3
2 n -9007199254740992
2 open true
2 p 0x1.4666666666666p+2
2 q 0x1.051eb8p-1
3 G 20
3 S 2
3 T 0
3 limit 3
3 n -9007199254740991
3 open true
3 p 0x1.4666666666666p+2
3 q 0x1.051eb8p-1
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
smc: --trace-format=exact does not name the script in its lines: trace one script at a time, or as csv
Try 'smc test --help'.
smc: --trace-format=exact always has every element: remove --trace-elements
Try 'smc test --help'.
smc: --trace-format is csv or exact, not 'json'
Try 'smc test --help'.
-- exit --
0 2 2 2
