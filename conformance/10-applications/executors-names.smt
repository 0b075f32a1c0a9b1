spec 10.9   An executor is named once, by an identifier.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    task a
[flight]              #! E1039 duplicate executor 'flight'
every 10 ms:
    task b
[10Hz]                #! E1026 10Hz
every 10 ms:
    task c
[a/b]                 #! E1026 a/b
every 10 ms:
    task d
[not]                 #! E1026 not
every 10 ms:
    task e
-- rocket.sv --
[options]
lock
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
