spec 5.20   A statement in which an error was found causes no warnings of flow; one without does.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
bool on
[Hold]
.step
    -> Vent if p > 5          #! E0330
    x = 1
[Vent]
.step
    goto Hold                 #! E0329
    x = 2
[Wait]
.step
    -> Hold
    x = 3                     #! W0501
