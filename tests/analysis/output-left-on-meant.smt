# A guarded block that switches an output on and goes to the state means it to be on there; another branch, another guard or the state's
# own course do not.
warn no-all output-left-on

-- app.sm --
[state_vector]
U64 G
U32 S
bool run @read_only
F32 level @read_only @range 0 100
bool failed
bool pump
bool horn
bool lamp
[Off] @safe
.entry
    failed = false
    pump = false
    horn = false
    lamp = false
.step
    run: -> Fill
[Fill]
.step
    level > 95 {
        failed = true
        -> Stop
    }
    level > 50: pump = true
    level < 5: -> Stop              # pump and lamp may be on here
    T > 100 {
        horn = true
        level > 30: -> Stop         # a guard of its own: the horn may sound long before
    }
    level > 20 or level < 10: lamp = true
    else: -> Stop                   # the other branch
[Stop] @safe                        #! W0922 the machine can rest in 'Stop' with 'pump', 'lamp' and 'horn' still on
.step
    not run: -> Off
