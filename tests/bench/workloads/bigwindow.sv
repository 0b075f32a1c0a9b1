[In]
U64   time      # ms
F64   pressure  # psi

[Out]
U32   state
F64   middle
F64   low
F64   high
