# Outputs that a state leaves on where nothing that follows sees to them.
warn no-all output-left-on

-- forgets.sm --
[state_vector]
U64 G
U32 S
bool run @read_only
F32 level @read_only
bool valve
bool heater
bool lamp
bool charge
bool horn
[Idle]                              #! W0922 the machine can rest in 'Idle' with 'valve', 'lamp', 'charge' and 'horn' still on
.step
    run: -> Fill
[Fill]
.entry
    valve = true
    heater = true
    lamp = true
    charge = true
    horn = true                     # nothing ever switches it off
.step
    T > 100: charge = false         # cut in time
    not run: -> Idle
    T > 5000 {
        valve = false
        -> Done
    }
    level > 90: -> Hold
.exit
    heater = false
[Hold] @safe                        #! W0922 the machine can rest in 'Hold' with 'valve', 'charge' and 'horn' still on
.entry
    lamp = false
.step
    not run: -> Idle
[Done] @safe                        #! W0922 with 'horn' still on
.entry
    lamp = false
.step
    not run: -> Idle
