spec 10.11   A time follows every, a frequency follows at.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 100 Hz:                #! E1027 did you mean 'at 100 Hz'
    task a
at 10 ms:                    #! E1027 did you mean 'every 10 ms'
    task b
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
