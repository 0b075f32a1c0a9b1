spec 7.29  rising(c) and falling(c) compare this sample of c with the one before.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 ups
F64 downs
bool up
bool down
[all_states]
.step
    up = rising(p > 3)
    down = falling(p > 3)
    rising(p): ups = ups + 1
    not not falling(p): downs = downs + 1
[Run]
.step
    T > 0: -> Next
[Next]

-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: p = 5
G == 0: @assert not up and not down
G == 2: p = 3
G == 2: @assert down and not up
G == 3: @assert not down and not up
G == 4: p = 4
G == 4: @assert up and not down
G == 5: p = 0
G == 5: @assert down and not up and downs == 1 and ups == 0
G == 6: p = 0
G == 7: p = -1
G == 7: @assert ups == 1 and not up
G == 7: @stop
