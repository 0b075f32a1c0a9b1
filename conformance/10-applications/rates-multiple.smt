spec 10.12   Periods are whole multiples of the shortest.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 25 ms:                  #! E1035 20 ms or 30 ms
    task a
every 10 ms:
    task b
at 3 Hz:                      #! E1036 333333333 ns
    task c
every 1.5 ns:                 #! E1036
    task d
every 20 ms:
    task e
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
