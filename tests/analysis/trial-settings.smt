# Trial runs with parameters: at both ends of their ranges. With the defaults nothing is found.
warn no-all flight

-- ends.sm --
[state_vector]
U64 G
U32 S
F64 p @range 0 100
F64 q @range 0 100
bool go @command
bool a
bool b
bool c
bool d
[options]
step 10 ms
[local]
F64 high = 200    @parameter @range 50 300
F64 low  = -5     @parameter @range -10 60
U8  most = 0      @parameter @range 0 9
U16 wait = 60000  @parameter @range 100 60000
U8  n    = 0
[Coast]
.step
    if p > high: a = true                       #! W0903 'p' alone switches on 'a'
    if T > wait: d = true
    T > 20 s: -> Rest
.exit
    a = false
[Rest] @safe                                    #! W0922 with 'd' still on
.step
    go: -> Count
.exit
    d = false
[Count]
.step
    if q < low: b = true                        #! W0903 'q' alone switches on 'b'
    n = n + 1
    if n >= 250: n = 0
    if most > 5 and n > most: c = true
    T > 20 s: -> Done
.exit
    b = false
[Done] @safe                                    #! W0922 with 'c' still on
