# smc sweep: where asserts and requirements begin to fail, with the margins of the current setting; a map of two parameters; every format.
args sweep v.sm v.ss v.rq --set limit=700:900:11
args sweep v.sm v.ss v.rq --set limit=700:900:21 --set wait=0:400:5
args sweep v.sm v.ss --set limit=700:900:3 --set=wait=10 --format=csv
args sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.json -MD; cat s.json s.d
args sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.svg; "$SMC" sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.svg; cat s.svg
args sweep v.sm v.ss --set limit=800:900:2 | tail -n 1
args sweep v.sm v.ss --set on=false:true:5
args sweep v.sm never.ss --set wait=0:3:20
args sweep v.sm v.ss
args sweep v.sm v.ss --set limit=1:800:3
args sweep v.sm v.ss --set limit=800:700:3
args sweep v.sm v.ss --set limit=700:700:3
args sweep v.sm v.ss --set limit=700:800:1
args sweep v.sm v.ss --set limit=700:800:0
args sweep v.sm v.ss --set limit=700:800
args sweep v.sm v.ss --set limit=700:high:3
args sweep v.sm v.ss --set other=1:2:3
args sweep v.sm v.ss --set limit=700:800:3 --set limit=700:800:3
args sweep v.sm v.ss --set limit=700:800:200 --set wait=0:400:200
args sweep v.sm v.ss --set limit=700:800:3 --set wait=0:4:2 --set on=false:true:2

-- v.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only @range 0 1000
bool open
[local]
F64 limit = 775 @parameter @range 500 1000
U32 wait = 50 @parameter @range 0 500
bool on = true @parameter @range false true
[Fill]
.step
    open = p > limit and on
    p > 825 and T > wait: -> Abort
[Abort] @abort @safe
.entry
    open = true
-- v.ss --
[all_states]
true: p = G
at 760: @assert not open
at 820: @assert open
at 900: @assert state Abort
at 2 s: @stop
-- never.ss --
[all_states]
true: p = 1
at 1 s: @stop
-- v.rq --
R1 "open above 800" always p > 800 implies open
-- stderr --
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
cat: s.json: No such file or directory
cat: s.d: No such file or directory
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
cat: s.svg: No such file or directory
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
v.sm:11:34: error: expected a number, the lowest value of '@range', found 'false' [E0377]
   11 | bool on = true @parameter @range false true
      |                                  ^~~~~ write two numbers, as in @range 0 40
1 error
-- exit --
1 1 1 1 1 0 1 1 1 1 1 1 1 1 1 1 1 1 1 1
