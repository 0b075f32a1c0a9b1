spec 10.10   An element receives one statistic of an executor.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight] @late late @busy late     #! E1047 late
    @ticks time                    #! E1047 the time
every 10 ms:
    task navigation
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
