spec 3.11   A condition compares with one value at a time.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    S in (Hold, Vent): v = 1                 #! E0329 write S == Hold or S == Vent
    v > 1 and S not in [Hold, Vent]: v = 1   #! E0329 write (S != Hold and S != Vent)
    if S is in {Hold}: v = 1                 #! E0329 write S == Hold
    v in (1, 2, 3): -> Vent                  #! E0329 write v == 1 or v == 2 or v == 3
    v in (1, 5): -> Vent                     #! E0329 write v == 1 or v == 5; for a range of values, 1 <= v <= 5
    v + 1 in (1, 5): -> Vent                 #! E0329 x == a or x == b
    valve in Vent: v = 1                     #! E0329 write valve and S == Vent if a state is meant
    v in range(5): -> Vent                   #! E0329 v == a or v == b
    state in (Hold, Vent): v = 1             #! E0329 write S == Hold or S == Vent
    S == Hold, Vent: v = 1                   #! E0315 write S == Hold or S == Vent
    S == (Hold, Vent): v = 1                 #! E0313 write S == Hold or S == Vent
[Vent]
.entry
