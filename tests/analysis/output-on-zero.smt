# Outputs that go on because a sensor reads 0.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  pressure @read_only
F64  temp     @read_only @range -40 100
F32  loop     @read_only @range 4 20
U16  level    @read_only
F64  wall     @read_only
U8   mode     @read_only
bool armed    @read_only
bool heater
bool valve
F64  setting
U8   fault
[local]
F64  filtered = 0
F64  later = 20
F64  low = 5
bool cold = false
F64  least = 5 @read_only
F64  unmarked = 5

[Guards]
.step
    pressure < 5: heater = true                         #! W0903 'heater' goes on when 'pressure' reads 0
    5 > pressure: setting = 40                          #! W0903 'setting'
    pressure > 5: heater = true
    pressure < 5: setting = 40 - 40 * (T > 100)
    pressure > 5: valve = false
    else: valve = true                                  #! W0903 'valve' goes on when 'pressure'
    T > 5000: -> Conjunctions
[Conjunctions]
.step
    pressure < 5 and armed: heater = true               #! W0903
    pressure < 5 and T > 100: heater = true             #! W0903
    pressure < 5 and temp > 20: heater = true           # asks a healthy sensor
    pressure < 5 and wall < 20: heater = true
    temp > 20 {
        pressure < 5: heater = true                     # asks it around
    }
    temp > 20: valve = false
    else if pressure < 5: valve = true                  #! W0903 'pressure' reads 0
    T > 5000: -> Branches
[Branches]
.step
    pressure > 40: valve = false
    else if armed: heater = true                        # the switch does, pressure only forbids
    else if temp > 5: valve = false
    else: valve = true                                  #! W0903 'valve' goes on when 'temp'
    wall > 40: setting = 0
    else {
        setting = 7                                     #! W0903 'wall'
        armed: setting = 8                              #! W0903 'wall'
    }
    T > 5000: -> Disjunctions
[Disjunctions]
.step
    pressure < 5 or armed: heater = true                #! W0903
    pressure < 5 or wall > 30: valve = true             #! W0903 'pressure' reads 0
    not (pressure > 5 or armed): setting = 7            #! W0903
    T > 5000: -> Excluded
[Excluded]
.step
    0.5 < pressure < 5: heater = true
    pressure < 5 and pressure > 0: heater = true
    pressure != 0 {
        pressure < 5: heater = true
    }
    wall < 0.5: -> Guards
    wall < 5: heater = true                             # 0 has left before
    T > 5000: -> Tests
[Tests]
.step
    not (2 < pressure < 300): fault = 3                 # a test of the reading
    level < 2 or level > 900: fault = 4
    loop < 4: fault = 5                                 # no healthy sensor reads this
    loop < 6: fault = 6                                 #! W0903 'fault' goes on when 'loop'
    temp < 5: heater = true                             #! W0903 'temp'
    pressure < 1 {
        heater = true
        -> Abort
    }
    T > 5000: -> Values
[Values]
.step
    heater = pressure < 5                               #! W0903 'heater'
    valve = pressure > 5
    setting = 100 - pressure                            # a controller, no guard
    pressure < 5: setting = pressure * 2                # which is 0
    pressure < 5: setting = wall                        # not known to be on
    pressure < 5: heater = pressure < 3                 #! W0903
    pressure < 5: heater = armed
    T > 5000: -> Overruled
[Overruled]
.step
    pressure < 5: heater = true
    pressure < 1: heater = false                        # switches it off again
    pressure < 5: setting = 3
    setting = wall
    armed {
        pressure < 5 {
            fault = 3                                   # the next one has the last word
            fault = 4 * armed
        }
    }
    T > 5000: -> Derived
[Derived]
.step
    roll_avg(pressure, 10) < 5: heater = true           #! W0903
    cold = wall < 10
    cold: valve = true                                  #! W0903 'wall'
    filtered = filtered + 0.1 * (pressure - filtered)
    later = pressure
    T > 5000: -> Filter
[Filter]
.step
    filtered < 15: heater = true                        #! W0903 'pressure'
    later < 15: valve = true                            # not said to be stored before
    pressure < low: valve = true                        # low can be anything
    low = G
    pressure < least: setting = 3                       #! W0903
    pressure < unmarked: fault = 3                      #! W0903
    T > 5000: -> Others
[Others]
.step
    mode == 0: heater = true                            # a command
    not armed: heater = true
    T < 5: heater = true
    pressure >= 0 or pressure < 0: valve = true         # holds of every reading
    T > 5000: -> Abort
.exit
    pressure < 5: setting = 4                           #! W0903
[Abort] @abort @safe
.step
    pressure < 5: valve = true                          #! W0903
