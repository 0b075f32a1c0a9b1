spec 13.1, 13.2, 13.6, 13.7, 13.8, 13.12  Sentences of other languages about time and consequences.

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
    p > 1: -> B
[B]
.step
    p < 1: -> A

-- app.rq --
R1 "limit"     always p > 5 implies valve within 1 s       #! E0330 write p > 5 leads to valve within 1 s
R2 "then"      always p > 5 then valve                     #! E0330 write implies
R3 "arrow"     always p > 5 -> valve                       #! E0330 write implies
R4 "arrow"     always p > 5 => valve                       #! E0107 write implies
R5 "after"     always valve within 1 s after p > 5         #! E0330 write always p > 5 leads to valve within 1 s
R6 "colon":    never p > 5                                 #! E1302 leave it out
R7 "sign" =    never p > 5                                 #! E1302 leave it out
R8 "soon"      eventually valve                            #! E1302 write always CONDITION leads to valve within 500 ms
R9 "no word"   p < 5                                       #! E1302 as in always p < 5
R10 "assert"   assert p < 5                                #! E1302 write always p < 5
R11 "for"      never valve for 5 s                         #! E0330 write held(valve, 5 s)
R12 "if"       if p > 5 then valve within 1 s              #! E1302 write always p > 5 leads to valve within 1 s
R13 "when"     when p > 5, valve                           #! E1302 write always p > 5 implies valve
R14 "never"    never p > 5 implies valve within 5 s        #! E1306 write always p > 5 leads to not (valve)
R15 "list"     never S in (A, B)                           #! E0329 write S == A or S == B
R16 "list"     never S in A, B                             #! E0329 write S == A or S == B
R17 "list"     never S == A, B                             #! E0330 write S == A or S == B
R18 "state"    never valve in B                            #! E0329 write valve and S == B if a state is meant
R19 "state"    never state in (A)                          #! E0329 write state == A
R20 "state"    never B                                     #! E0204 S == B tests for it
