spec 5.20   An unknown name is reported where it is first used, and not again.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure
[local]
F64 y = nothing           #! E0204 unknown element 'nothing'
[Hold]
.entry
    pressure = nothing + 1
    nothing = 2
.step
    nothing > nothing: other = nothing     #! E0204 'other'
    y = roll_avg(other, nothing)
