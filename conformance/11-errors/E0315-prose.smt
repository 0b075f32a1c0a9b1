spec 5.30   What follows a guard on its line and is no statement does not become one by a colon.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
bool on
[Hold]
.step
    if p between 3 and 5: x = 1         #! E0315 write 3 <= p <= 5
    if p > 5 of max: x = 1              #! E0315 'of'
    if p > 5 for 500 ms: x = 1          #! E0315 write held(p > 5, 500 ms)
    if p > 5, x = 1                     #! E0315 write ':' instead
    if abs p > 5: x = 1                 #! E0219 write abs(x)
    if p > 5 -> Hold                    #! E0315 insert ':'
    if p > 5 x = 1                      #! E0315 insert ':'
    x = 1, p = 2                        #! E0330 put each statement on a line of its own
    x = 1 p = 2                         #! E0330 put each statement on a line of its own
    if on { x = 1 -> Hold }             #! E0330 condition: -> State
    x = 2 (p + 1)                       #! E0330 to multiply, write *
    x = if p > 5: 1 else 0              #! E0312 write it as if ...
    p > 5: - > Hold                     #! E0312 write ->
    if and(p > 5, on): x = 1            #! E0312 write a and b
