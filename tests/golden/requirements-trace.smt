# A trace has a last column with the requirements that the step has violated.
args test --trace=o.csv a.sm a.ss a.rq >/dev/null 2>&1; head -1 o.csv; grep -n R o.csv

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad] @req R1
.step
    p > 100: -> Drogue @req R3
[Drogue]
.entry
    drogue = true @req R4
.step
    if T > 50 { -> Main } @req R3
[Main] @safe
.entry
    main = true
-- a.ss --
[all_states]
G == 0: p = 0
G == 100: p = 200
G == 300 {
    @assert main @req R2
    @stop
}
-- a.rq --
R1 "low pressure"   never S == Drogue and roll_max(p, 3 steps) > 10
R2 "main first"     never Drogue before Main
R3 "main in time"   always p > 100 leads to main within 40 ms
R4 "through main"   never Drogue after Pad without Main
R5 "main goes off"  always main leads to not main within 10 s
-- stdout --
script,step,G,state,T,drogue,main,p,violated
13:a.ss,12,110,Drogue,0,1,0,200,R1 R2 R4
14:a.ss,13,120,Drogue,10,1,0,200,R1 R2 R4
15:a.ss,14,130,Drogue,20,1,0,200,R1 R2 R4
16:a.ss,15,140,Drogue,30,1,0,200,R1 R2 R3 R4
17:a.ss,16,150,Drogue,40,1,0,200,R1 R2 R4
18:a.ss,17,160,Drogue,50,1,0,200,R1 R2 R4
19:a.ss,18,170,Drogue,60,1,0,200,R1 R2 R4
