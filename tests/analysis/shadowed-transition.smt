spec 6.18   A transition is found whose guard is true only where an earlier transition has left the state, in every spelling.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool ready
bool valve
U8 level
[local]
F64 x = 0
[Bounds]
.step
    p > 10: -> A
    p > 20: -> B                         #! W0506 this transition is never made: whenever its guard is true, an earlier transition has been made
    p >= 10 and q > 1: -> C
    15 < p <= 18: -> C                   #! W0506
[A]
.step
    p > 10 and q > 5: -> Bounds
    p > 20 and q > 6: -> B               #! W0506
    q > 6 and p > 11 and ready: -> B     #! W0506
    p > 20 and q > 4: -> C
[B]
.step
    p > q: -> A
    p > q + 5: -> C                      #! W0506
    q + 1 < p: -> C                      #! W0506
    p > q - 5: -> D
    p == q: -> A
[C]
.step
    ready or p > 5: -> A
    ready: -> B                          #! W0506
    p > 6 or ready and q > 1: -> B       #! W0506
    p >= 6: -> D                         #! W0506
[D]
.step
    level == 1 {
        valve = true
        -> A
    }
    level < 5 {
        q > 1: -> B
        level == 1 and q > 0: -> C       #! W0506
        q > 2: -> C                      #! W0506
    }
    else if level > 7: -> B
    else if level > 8: -> C              #! W0506
    x = p
    x > 3: -> E
    x > 4: -> B                          #! W0506
    x > 1: -> B
[E]
.entry
    p > 10: -> A
.step
    p > 20: -> B                         #! W0506
    -> C
