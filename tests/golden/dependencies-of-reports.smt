# The rule of -MD names the messages of a report, the recorded data of the scripts from which cover starts, and the files of an application.
args report a.sm --sv a.sv --net a.net -o r.html -MD && cat r.d
args cover b.sm b.ss -o made -MD -MF made.d && cat made.d
args cover x.app -o joint --goals=transitions -MD -MF joint.d && cat joint.d
args prove x.app x.rq -o x.proof -MD && cat x.d*

-- a.sv --
[A]
U64 G
U32 S
F64 p
-- a.net --
receive commands on 5001 @timeout 500 ms { p @default 0 }
-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[Idle]
.step
    p > 1: -> Done
[Done]
-- b.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[Idle]
.step
    p > 1: -> Done
[Done]
-- b.csv --
t,p
0,0
10,2
20,2
-- b.ss --
[options]
delta_t 10 ms
[data]
file "b.csv"
time "t" ms
p = "p"
[all_states]
at 20: @assert S == Done
at 20: @stop
-- x.app --
[options]
state_vector "a.sv"
time         G 1 ms

[all]
every 10 ms:
    machine b "b.sm"
-- x.rq --
R1 "idle or done"  always b.S == Idle or b.S == Done
-- stdout --
r.html: a.sm a.sv a.net
goals of b: 0 of 0 reached
made: b.sm b.ss b.csv
goals of b: 1 of 1 reached
wrote joint/x-b-1-idle-to-done.ss: b: Idle -> Done, taken because p > 1.
joint: x.app a.sv b.sm
x.proof: x.app x.rq a.sv b.sm
