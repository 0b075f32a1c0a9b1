spec 5.2   When a state vector is given, each listed element must exist there.
-- app.sv --
[Main]
U64 G
U32 S
F64 tankPressure
-- app.sm --
[state_vector]
U64 G
U32 S
F64 tankPresure       #! E0205 did you mean 'tankPressure'?
F64 extra             #! E0205 the state vector has no element 'extra'
[Hold]
.step
    tankPresure > 5: -> Hold
    extra = 1
