# Everything at once: aliases, locals, a conditional with an else, windows in windows, a script that asserts and fails.

-- tank.sm --
[state_vector]
U64 time @alias G
U32 state @alias S
F64 pressure @read_only
bool valve
F32 smooth
[local]
F64 limit = 3.5 * 2 @read_only
U16 count = 0
[Fill]
.entry
    count = 0
.step
    if pressure > 775 or valve {
        valve = not valve
        count = count + 1
    }
    else if 1 < count <= 3: smooth = roll_avg(roll_median(pressure, 3) * limit, 5)
    else: valve = clamp(pressure, 0, 1)
    T > 20: -> Idle
.exit
    valve = true
[Idle]
[Never]
.step
    -> Fill
-- tank.ss --
[options]
delta_t 3
[all_states]
true { pressure = pressure + 100
       limit = 8 }
G > 12: @assert roll_max(pressure, 4) < 900
G > 40: @stop
