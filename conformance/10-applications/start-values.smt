spec 10.8   Values are made of numbers, once for each element.

-- rocket.app --
[options]
state_vector "rocket.sv"
[start]
altitude = target * 2        #! E1041 a value of [start] must be computed from numbers
mode     = 1
mode     = 2                 #! E1042 duplicate value for 'mode'
target   = roll_avg(1, 3)    #! E1041
otherMode = (1 +             
late 5                       #! E0313
busy = max(1)                #! E0401
small 5                      #! E1020 engineMode = 2
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
