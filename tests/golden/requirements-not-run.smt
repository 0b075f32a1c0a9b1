# An error in a file of requirements: no script runs, and the last line says so.
args test a.sm a.ss b.ss a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool open
[Only] @safe
.step
    open = p > 1
-- a.ss --
[all_states]
at 0: p = 2
at 20 ms: @assert open
at 20 ms: @stop
-- b.ss --
[all_states]
at 0: p = 0
at 20 ms: @assert not open
at 20 ms: @stop
-- a.rq --
R1 "opens" always p > 1
    leads to open within 20 ms
-- stdout --
0 passed, 0 failed, 2 did not run
-- stderr --
a.rq:2:5: error: 'leads' cannot begin a line of its own: write it at the end of the line before [E1313]
    2 |     leads to open within 20 ms
      |     ^~~~~
1 error
-- exit --
1
