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
[Idle]
.step
    run: -> Fill
[Fill]
.entry
    valve = true
    heater = true
    lamp = true
    charge = true
    horn = true                     #! W0923 nothing ever switches 'horn' off again
.step
    T > 100: charge = false         # cut in time
    not run: -> Idle                #! W0922 'valve' stays on when the machine goes from 'Fill' to 'Idle' here
    T > 5000 {
        valve = false
        -> Done
    }
    level > 90: -> Hold             #! W0922 goes from 'Fill' to 'Hold'
.exit
    heater = false
[Hold] @safe
.entry
    lamp = false
.step
    not run: -> Idle
[Done] @safe
.entry
    lamp = false
.step
    not run: -> Idle
