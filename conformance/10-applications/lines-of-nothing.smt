spec 10.1, 10.11   After any error at the beginning of a line, the next line is read.

-- rocket.app --
[options]
state_vector "rocket.sv"
"x"                          #! E1021 "x"
events 1                     #! E1034
[flight] 7                   #! E1023 7
"y"                          #! E1023 "y"
every
8                            #! E1020 a unit
task                         #! E1020 the task's name
every 10 ms:
    task a
machine
m                            #! E1020 name of a file
5                            #! E1023 number 5
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
