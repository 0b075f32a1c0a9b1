spec 3.30, 3.32   A state is compared with S alone.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    S == (Hold or Vent): v = 1               #! E0204 write (S == Hold or S == Vent)
    (S == Hold or Vent                       #! E0204 write S == Vent
        or Abort): v = 1                     #! E0204 write S == Abort
    -> Vent
[Vent]
.step
    -> Abort
[Abort]
.entry
