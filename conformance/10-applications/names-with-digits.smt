spec 10.17   A name begins with a letter.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1ms                #! E1028 1 ms
[flight] @ticks 2late        #! E1051 2late
every 10 ms:
    task 2plant              #! E1051 2plant
    task a @mode 2mode       #! E1051 2mode
-- rocket.sv --
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
F64  target
