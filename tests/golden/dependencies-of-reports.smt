# The rule of -MD names the messages of a report, the recorded data of the scripts from which cover starts, and what mutate, graph and the files of an
# application depend on.
args report a.sm --sv a.sv --net a.net -o r.html -MD && cat r.d
args cover b.sm b.ss -o made -MD -MF made.d && cat made.d
args mutate b.sm b.ss -o m.txt -MD && cat m.d
args graph b.sm b.ss -o g.svg -MD -MT picture && cat g.d
args mutate b.sm b.ss -MD
args graph b.sm -MD
args report stand.app stand.ss -o app.html -MD && cat app.d
args faults stand.app stand.ss -o f.txt -MD; cat f.d

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
-- stand.app --
[options]
state_vector "a.sv"
time         G 1 ms

[stand]
every 10 ms:
    machine b "b.sm"
-- stand.ss --
[all_states]
at 20: p = 2
at 40: @assert b.S == Done
at 40: @stop
-- stdout --
r.html: a.sm a.sv a.net
goals of b: 0 of 0 reached
made: b.sm b.ss b.csv
m.txt: b.sm b.ss b.csv
picture: b.sm b.ss b.csv
app.html: stand.app stand.ss a.sv b.sm
f.txt: stand.app stand.ss a.sv b.sm
-- stderr --
smc: standard output has no name that -MD can derive a name from: name the rule's file with -MF
Try 'smc mutate --help'.
smc: standard output has no name that -MD can derive a name from: name the rule's file with -MF
Try 'smc graph --help'.
smc: faults under "failed" (12) fail asserts, which describe a flight without faults: write what must hold with any fault as requirements, in a .rq file
-- exit --
0 0 0 0 2 2 0 0
