# A state vector of its own, a machine that lists a part of it, types of every size.

-- flight.sv --
[Sensors]
F32 accel
I8 mode
I64 big
[Actuators]
bool fire
U16 angle
[Base]
U64 G
U32 S
[options]
lock
-- app.sm --
[state_vector]
U64 G
U32 S
F32 accel @read_only
bool fire
U16 angle
[Coast]
.step
    angle = angle + roll_range(accel, 7)
    accel < -1 { fire = true
        -> Apogee }
[Apogee]
.entry
    fire = false
-- app.ss --
[options]
delta_t 1000000
[Coast]
true: accel = 1 - T / 3000000
[Apogee]
T > 3: @assert !fire
T > 5: @stop
