spec 5.20   A name that is neither listed nor a local nor T is an error, with the nearest name offered.
-- app.sm --
[state_vector]
U64  G
U32  S
bool valveOpen
[Vent]
.step
    valve0pe = true       #! E0204 did you mean 'valveOpen'?
