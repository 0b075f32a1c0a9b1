spec 10.12   A period is 1 us to 1 h.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    task a
every 999 ns:                 #! E1034 1 us to 1 h
    task b
every 3600.01 s:              #! E1034 1 us to 1 h
    task c
at 0 Hz:                      #! E1034 1 us to 1 h
    task d
at 1e300 kHz:                 #! E1034
    task e
at 1e-300 Hz:                 #! E1034
    task f
every 0 ms:                   #! E1034
    task g
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
