spec 10.11   A rate is `every` and a time, or `at` and a frequency.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight]
every ms:                     #! E1020 every 10 ms:
    task a
every 10 ms                   #! E1020 ':'
    task b
at 10:                        #! E1020 Hz or kHz
    task c
evry 10 ms:                   #! E1023 every
    task d
navigation                    #! E1023 'navigation'
tsk e                         #! E1023 task
task                          #! E1020 the task's name
task 5                        #! E1020 the task's name
task if                       #! E0354 if
machine mission               #! E1020 "mission.sm"
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
