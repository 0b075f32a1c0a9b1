[Channels]
U64  time
U32  state
U32  drogueState
U32  spareState
bool armed
bool go
bool apogee
bool fire
bool fireDrogue
bool fireSpare
