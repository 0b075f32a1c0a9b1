# A hysteresis with exchanged limits.  Not one with a band, two limits in one direction, limits of different values, a limit that leaves the state,
# a value that is assigned between them, and the same value twice.  Not two numbers, and not where the variable is read between them.
warn no-all overlapping-limits

-- app.sm --
[state_vector]
U64  time    @alias G
U32  state   @alias S
F32  line    @read_only
F32  tank    @read_only
bool valve
bool heater
bool lamp
U8   level
U8   zone

[local]
F32  last = 0

[Keep]
.step
    line > 95: valve = true
    line < 98: valve = false                  #! W0916 'valve' is switched on and off in the same step while 95 < line < 98
    20 > tank: heater = true
    tank > 15: heater = false                 #! W0916 'heater' is switched on and off in the same step while 15 < tank < 20
    line > 98: lamp = true
    line < 95: lamp = false
    line > 10: zone = 2
    line < 30: zone = 1
    T > 10 s: -> Rest

[Rest]
.step
    tank > 40: heater = true
    heater: level = 3
    tank < 50: heater = false
    line > 95: level = 1
    line > 98: level = 2
    tank < 98: valve = true
    line > 95: valve = false
    last > 95: lamp = true
    last = line
    last < 98: lamp = false
    line > 90: heater = true
    line < 93 {
        heater = false
        -> Keep
    }
