spec 10.3, 10.8, 10.10, 10.16   An element that the state vector does not have is an error.

-- rocket.app --
[options]
state_vector "rocket.sv"
time tim 1 ms                #! E0204 time
[start]
altitud = 1                  #! E0204 altitude
[flight] @late lat           #! E0204 late
every 10 ms:
    task navigation @mode Mode     #! E0204 mode
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
