spec 10.19   A step of a machine is as long as its group's period: by T > 6000 there have been 62 of 100 ms.
warn window-not-full

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    task sensor
every 100 ms:
    machine load "load.sm"
-- rocket.sv --
[A]
U64  time
U32  state
F32  wind
-- load.sm --
[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  wind   @read_only
[Hold]
.step
    T > 6000 and roll_avg(wind, 600) < 5: -> Load        #! W0965 has 62 of 600 samples
    T > 6000 and roll_avg(wind, 62) < 4: -> Load
[Load]
.step
    T > 200: -> Hold
