spec 10.1   Other options are an error; the nearest is named.

-- rocket.app --
[options]
state_vector "rocket.sv"
watch_dog 500 ms       #! E1021 watchdog
io_file "x"            #! E1021
5                      #! E1021 number 5
[flight]
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
