spec 10.2, 10.6, 10.13   They need their option.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    inputs                    #! E0830 'io' in [options]
    log                       #! E0830 'log' in [options]
    keep                      #! E0830 'keep' in [options]
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
