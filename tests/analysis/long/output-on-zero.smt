# Outputs that go on because one sensor has failed.  Each statement has an output of its own, which each state switches off first.
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
bool a
bool b
bool c
bool d
bool e
bool f
bool g
F64  power
[Guards]
.entry
    a = false
    b = false
    c = false
    d = false
.step
    pressure < 5: a = true                              #! W0903 'pressure' alone switches on 'a' when it reads 0
    5 > pressure: b = true                              #! W0903 'b'
    pressure > 5: c = true
    pressure > 5: d = false
    else: d = true                                      #! W0903 'd'
    T > 5000: -> Conjunctions
[Conjunctions]
.entry
    a = false
    b = false
    c = false
    d = false
    e = false
.step
    pressure < 5 and armed: a = true                    #! W0903 'a'
    pressure < 5 and T > 100: b = true                  #! W0903 'b'
    pressure < 5 and temp > 20: c = true                # a second sensor agrees
    pressure < 5 and wall < 20: d = true
    temp > 20 {
        pressure < 5: e = true                          # it is asked around this
    }
    T > 5000: -> Branches
[Branches]
.entry
    a = false
    b = false
    power = 0
.step
    pressure > 40: a = false
    else if armed: b = true                             #! W0903 'b'
    else if wall > 7: a = false
    else: a = true                                      # both must read low
    wall > 30: power = 0
    else {
        power = 70                                      #! W0903 'wall' alone switches on 'power'
    }
    T > 5000: -> Disjunctions
[Disjunctions]
.entry
    a = false
    b = false
    power = 0
.step
    pressure < 5 or armed: a = true                     #! W0903
    pressure < 5 or wall > 30: b = true                 #! W0903 'pressure' alone
    not (pressure > 5 or armed): power = 70             #! W0903
    T > 5000: -> Excluded
[Excluded]
.entry
    a = false
    b = false
    c = false
.step
    0.5 < pressure < 5: a = true
    pressure < 5 and pressure > 0: b = true
    pressure != 0 {
        pressure < 5: c = true
    }
    T > 5000: -> Tests
[Tests]
.entry
    a = false
    b = false
    c = false
    d = false
    e = false
.step
    not (2 < pressure < 300): a = true                  # a test of the reading
    level < 2 or level > 900: b = true
    loop < 3.5: c = true                                # no healthy sensor reads this
    loop < 6: d = true                                  #! W0903 'd'
    temp < 5: e = true                                  #! W0903 'e'
    T > 5000: -> Values
[Values]
.entry
    a = false
    b = false
    power = 0
.step
    a = pressure < 5                                    #! W0903 'a'
    b = pressure > 5
    power = clamp((100 - wall) * 2, 0, 100)             #! W0903 'power'
    T > 5000: -> Overruled
[Overruled]
.entry
    a = false
    b = false
.step
    pressure < 5: a = true
    pressure < 1: a = false                             # switches it off again
    b = false
    armed {
        pressure < 5 {
            b = true                                    #! W0903 'b'
        }
    }
    T > 5000: -> Others
[Others]
.entry
    a = false
    b = false
    c = false
.step
    mode == 0: a = true                                 # a command
    not armed: b = true
    pressure >= 0 or pressure < 0: c = true             # true at every reading
    T > 5000: -> Done
[Done] @safe
.step
    T > 5000 and armed: -> Guards
    T > 9000 and armed: -> Abort
[Abort] @abort @safe
.step
    pressure < 5: g = true                              # what an abort does
