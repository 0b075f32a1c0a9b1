spec 10.8   A line of values begins with an element, which may be called like any word of an application.

-- rocket.app --
[options]
state_vector "rocket.sv"
[start]
time = 5
log = 1
5 = 6                        #! E1020 the name of an element
"x" = 7                      #! E1020 the name of an element
+                            #! E1020 the name of an element
@late late                   #! E1020 the name of an element
every = 2
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
U8 log
U8 every
