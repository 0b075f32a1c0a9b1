spec 10.3, 10.10, 10.16   Elements with a meaning for the runtime have a type.

-- rocket.app --
[options]
state_vector "rocket.sv"
time missionState 1 ms       #! E1033 a U64
[flight] @late altitude      #! E1033 of an integer type
    @busy small
every 10 ms:
    task navigation @mode small     #! E1033 a U8
    task other @mode mode
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
