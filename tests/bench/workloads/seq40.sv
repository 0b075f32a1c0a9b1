# The sensors and buttons first, then what the sequencer says and does.

[In]
U64   time        # ms
F32   lox         # bar
F32   fuel        # bar
F32   chamber     # bar
I16   chill       # degrees C, of the feed line
U16   bus         # mV
bool  go
bool  stop

[Out]
U32   state
F32   lowest      # bar, while a tank settles
U16   count       # steps to go
U8    holds
bool  loxVent
bool  fuelVent
bool  loxMain
bool  fuelMain
bool  purge
bool  igniter
bool  pressLox
bool  pressFuel
bool  chillValve
bool  armed
bool  lights
bool  camera
