spec 10.1   Names of files stand between quotation marks of the keyboard.

-- rocket.app --
[options]
state_vector 'rocket.sv'     #! E1029
keep "open                    #! E1029
[flight]
every 10 ms:
    task navigation
    keep
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
