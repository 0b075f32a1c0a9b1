spec 1.8   A state begins with its name in brackets; the edit writes them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
state Hold:                   #! E0329 write [Hold]
.step
    x = p
    on = true
    T > 5: -> Vent
STATE Vent                    #! E0329 write [Vent]
.step
    T > 5: -> Wait
def Wait():                   #! E0329 write [Wait]
