# Votes that count one sensor twice, or ignore one. Weights, definitions that overlap and different windows of one sensor are meant.
warn no-all repeated-operand

-- app.sm --
[state_vector]
U64 G
U32 S
F32 a @read_only
F32 b @read_only
F32 c @read_only
bool x @read_only
bool y @read_only
bool z @read_only
bool vent
F32 middle
U8 n
[define]
wrong  = max(min(a, b), min(max(a, b), a))     #! W0521 'b' has no effect here
right  = max(min(a, b), min(max(a, b), c))
votes  = (a > 3) + (b > 3) + (a > 3)           #! W0520 'a > 3' is already an operand here
ready  = x and y
low    = min(a, b)
[A] @safe
.step
    middle = median(a, b, a)                   #! W0521
    middle = median(a, b, c)
    middle = median(a, b, c, a, b)
    middle = median(a, b, a, c)
    middle = min(a, max(a, b)) + c             #! W0521
    middle = right + clamp(a, 0, 5) + min(max(a, 0), 5)
    middle = max(low, c) + a + a
    wrong > 3: vent = true
    votes >= 2: vent = true
    (x and y) or (y and z) or (y and x): vent = true        #! W0520 'y and x' is already an operand here
    (x and y) or (y and z) or (x and z): vent = false
    a > 3 and b > 3 and a > 3: vent = true     #! W0520
    x or x and z: vent = true                  #! W0521 'z' has no effect here
    ready and y: vent = true
    2 * (a > 3) + (b > 3) >= 2: vent = true
    (roll_min(a, 3) > 3) + (roll_min(a, 4) > 3) + (a > 3) >= 2: vent = false
    (roll_min(a, 3) > 3) + (roll_min(b, 3) > 3) + (roll_min(a, 3) > 3) >= 2: vent = false       #! W0520
    x + y + x >= 2: vent = true                #! W0520
    not x and y and z and not x: vent = true   #! W0520
    n = 0
    a > 3: n = n + 1
    b > 3: n = n + 1
    a > 3: n = n + 1                           #! W0520 'a > 3' is already an operand here
    n >= 2: vent = true
    n = 0
    a > 3: n = n + 1
    b > 3: n = n + 2
    a > 3: n = n + 3
    n > 1: n = n + 1
    n > 1: n = n + 1
    a > 3: vent = false
