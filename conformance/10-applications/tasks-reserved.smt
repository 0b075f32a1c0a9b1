spec 10.17   Some names C or the runtime has taken.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every 10 ms:
    task sm                   #! E1046 belongs to the runtime
    task _a                   #! E1046 underscore
    task b__c                 #! E1046 two underscores
    task inputs
    task every
    task machine
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
