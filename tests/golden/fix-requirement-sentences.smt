# smc fix writes 'leads to' where a requirement has a time limit, and 'implies' for a consequence.
args fix app.sm app.rq
args check app.sm app.rq

-- app.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool valve
[A]
.step
    valve = p > 1
    p > 1: -> B
[B]
.step
    valve = p > 1
    p < 1: -> A
-- app.rq --
R1 "limit"     always p > 5 implies valve within 1 s
R2 "then"      always p > 5 then valve
R3 "arrow"     always p > 5 -> valve
R4 "arrow"     always p > 5 => valve
R6 "colon":    never p > 5
R11 "for"      never valve for 5 s
R15 "list"     never valve and S in (A, B)
-- stdout --
app.rq:1:
  - R1 "limit"     always p > 5 implies valve within 1 s
  - R2 "then"      always p > 5 then valve
  - R3 "arrow"     always p > 5 -> valve
  - R4 "arrow"     always p > 5 => valve
  - R6 "colon":    never p > 5
  - R11 "for"      never valve for 5 s
  - R15 "list"     never valve and S in (A, B)
  + R1 "limit"     always p > 5 leads to valve within 1 s
  + R2 "then"      always p > 5 implies valve
  + R3 "arrow"     always p > 5 implies valve
  + R4 "arrow"     always p > 5 implies valve
  + R6 "colon"    never p > 5
  + R11 "for"      never held(valve, 5 s)
  + R15 "list"     never valve and (S == A or S == B)
app.rq: 7 fixed
