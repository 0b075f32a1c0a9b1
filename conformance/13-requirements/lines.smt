spec 13.2, 13.5  A requirement has an id, a text and a demand, and ends with its line.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
F64 q @read_only
bool on

[define]
high = p > 10

[A]
.step
    on = false
    p == 1: -> B
    p == 2: -> C

[B]
.step
    on = true
    p == 0: -> A
    p == 2: -> C

[C]
.step
    on = true
    p == 0: -> A
    p == 1 and not high: -> B

-- app.rq --
R1 never p > 1                       #! E1301 expected the text
R3 "" never p > 1                    #! E1301 an empty text
R4 "a" nver p > 1                    #! E1302 did you mean 'never'?
R5 "b" never p >                     #! E0312
1
R6 "c"
    never (p > 1
           and q > 2)
R7 "d" never p > 1 q                 #! E0330
R9 "g" always p > 1
    leads to q > 1 within 20 ms      #! E1313 'leads' cannot begin a line
R10 "h" always p > 1
    or q > 1                         #! E1313 'or'
R8 "e"                               #! E1302 found the end of the line
R8 "f" never                         #! E0312
