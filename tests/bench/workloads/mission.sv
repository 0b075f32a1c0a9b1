# The sensors come first, so that an input is one copy; then what the machine says.

[In]
U64   time          # ms
F64   altitude      # m above the sea, barometric
F32   acceleration  # m/s2 along the body
U16   battery       # mV
bool  armSwitch
bool  launchButton

[Out]
U32   state
F32   load          # m/s2, averaged
F64   height        # m above the pad, filtered
F64   apogee        # m above the pad
U8    faults
bool  igniter
bool  drogue
bool  mainChute
bool  beacon
