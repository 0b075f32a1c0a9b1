spec 10.2, 10.6, 10.13   They need their option.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    inputs                    #! E1030 'io' in [options]
    log                       #! E1030 'log' in [options]
    keep                      #! E1030 'keep' in [options]
    task a
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
