spec 10.10   Annotations of an executor stand once, behind its header.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight] @priority 1 @priority 2     #! E0361 priority
every 10 ms:
    task a @priority 3        #! E1024 '@priority' is not allowed after a task
    task b @mod mode          #! E0360 @mode
    log @safe                 #! E1024 'log', 'keep' and 'send'
    inputs @mode mode         #! E1024 'inputs'
    machine m "m.sm" @safe    #! E1024 '@safe' is not allowed after a machine
    outputs @init             #! E1024 'outputs'
[slow] @mode mode             #! E1024 an executor
every 10 ms:
    task c
[other] @overrun later        #! E1020 skip or catch_up
every 10 ms:
    task d
-- rocket.sv --
[options]
lock
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
