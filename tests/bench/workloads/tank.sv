# What the bench gives the tank (examples/tank) comes first, so that an input is one copy; then what it gives back.

[In]
U64   time          # ms
F64   tankPressure  # psi

[Out]
U32   state
bool  valveOpen
