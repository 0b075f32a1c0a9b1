spec 10.1, 10.11   Whatever stands where a line begins, the next line is read again.

-- rocket.app --
[options]
state_vector "rocket.sv"
"x"                          #! E0821 "x"
events 1                     #! E0834
[flight] 7                   #! E0823 7
"y"                          #! E0823 "y"
every
8                            #! E0820 a unit
task                         #! E0820 the task's name
every 10 ms:
    task a
machine
m                            #! E0820 name of a file
5                            #! E0823 number 5
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
