spec 5.9   A state after => at the end of a condition is the target of a transition; the edit writes a colon and ->. In a value, or before a colon or a brace, => compares.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    T > 5000 => Vent          #! E0107 ': ->'
    if p > 5 => Vent          #! E0107 ': ->'
    p > 5: => Vent            #! E0107 '->'
    on = p => x               #! E0107 '>='
    p => x: on = true         #! E0107 '>='
    p => x                    #! E0107 '>='
    {
        on = true
    }
[Vent]
