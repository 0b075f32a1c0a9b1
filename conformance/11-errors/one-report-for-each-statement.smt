spec 1.21   A statement of another language is reported once, at its first error, with what to write instead.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p @read_only
bool c @read_only
bool v
[Idle]
.step
    print("hi")                     #! E0106 a machine prints nothing
    log("x = ", x)                  #! E0106 a machine prints nothing
    echo "hi"                       #! E0106 a machine prints nothing
    state := Vent                   #! E0204 to go to the state 'Vent', write -> Vent
    state = "Vent"                  #! E0204 to go to the state 'Vent', write -> Vent
    transition(Vent)                #! E0217 to go to the state 'Vent', write -> Vent
    string s = "abc"                #! E0328 no variable can store a text
    var t = "abc"                   #! E0338 no variable can store a text
    let y = x + 1                   #! E0338 write 'F64 y = 0' in [local], and 'y = x + 1' here
    var on = true                   #! E0338 write 'bool on = true' in [local], and 'on = true' here
    const int k = 5                 #! E0338 write 'I32 k = 5 @read_only' in [local]
    raise Problem("abc")            #! E0328
    x = max([p, x])                 #! E0312 there are no lists
    if x in 3 to 5: v = true        #! E0329 write 3 <= x <= 5
    if x not in 3 to p: v = true    #! E0329 write not (3 <= x <= p)
    c { v = true
    end                             #! E0329 close braces with }
    c { p > 3 {
            v = false               # not }
        endif                       #! E0329 close braces with }
        c: v = true
    }
    end                             #! E0329 close braces with }
    c {
        if v then                   #! E0329 write '{' instead
            v = false
        end                         #! E0329 close braces with }
        x = 1
    }
[Vent]
.step
    -> Idle
