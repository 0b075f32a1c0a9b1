# Clocks made of counters, compared with a number that they step over.
warn no-all exact-moment
-- app.sm --
[state_vector]
U64  G
U32  S
bool a
bool b
[local]
U16 ms = 0
U16 tick = 2
F32 secs = 0
U8  down = 100
I16 many = 0
U16 by = 4 @read_only
[Run]
.entry
    ms = 0
    tick = 2
    secs = 0
.step
    ms = ms + 10
    tick = by + tick
    secs = secs + 0.01
    down = down - 3
    many = many + 3
    many = many + 4
    ms == 105: a = true                 #! W0408 'ms' is possibly never exactly 105
    ms != 105: b = true                 #! W0408
    ms == 100: a = false
    tick == 250: b = false
    tick == 252: b = true               #! W0408 'tick'
    secs == 1.5: a = true               #! W0408 'secs'
    secs == 0.25: b = true              #! W0408
    down == 1: a = false
    down == 2: a = true                 #! W0408
    many == 5: b = false
    ms == 0: b = true                   # where it begins
