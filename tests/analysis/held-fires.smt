# What a condition does that must be true for some time, also after a leap of time to the limit of a timer.
warn no-all flight

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @range 0 100
F64 q @range 0 100
bool a
bool b
bool c
bool d
[options]
step 10 ms
[Coast]
.step
    if held(p > 50, 100 ms): a = true                       #! W0903 'p' alone switches on 'a'
    if held(T > 5 s, 100 ms): b = true
    if T > 5 s and held(p > 50, 400 ms): c = true           #! W0903 'p' alone switches on 'c'
    if held(T > 5 s and q > 50, 100 ms): d = true           #! W0903 'q' alone switches on 'd'
    T > 20 s: -> Done
[Done] @safe                                                #! W0922 with 'b', 'a', 'c' and 'd' still on
