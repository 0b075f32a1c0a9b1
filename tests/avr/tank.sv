[Tank]
U64  time
U32  state
F64  tankPressure       # psi
bool valveOpen
