spec 5.17   A local named like an element that the machine does not list draws a warning.
-- app.sv --
[Main]
U64 G
U32 S
bool valveOpen
F64 flow
-- app.sm --
[state_vector]
U64 G
U32 S
F64 flow
[local]
bool valveOpen = false    #! W0202 'valveOpen' is declared here
[Hold]
.step
    valveOpen = flow > 5
    flow = valveOpen
