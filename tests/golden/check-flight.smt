# What the findings on broken sensors say: where, why, what to do.
args check -Wabort-blind -Wabort-single-sensor -Woutput-on-zero a.sm

-- a.sm --
[state_vector]
U64  G
U32  S
F32  pressure @read_only @range 1 60
F64  temperature @read_only
bool heater
bool valve
[local]
F64  smooth = 0
[Burn]
.entry
    valve = true
.step
    smooth = 0.8 * smooth + 0.2 * pressure
    smooth > 55: -> Close
    smooth < 0.5 and T > 100 {
        valve: -> Close
        else:  -> Abort
    }
    smooth < 20: heater = true
    temperature < 5: heater = true
[Close]
.entry
    valve = false
    -> Abort
[Abort] @abort @safe
-- stderr --
a.sm:10:2: warning: state 'Burn' cannot abort if 'pressure' sticks, say at 30.5: no transition to an @abort state is left [W0902 abort-single-sensor]
   10 | [Burn]
      |  ^~~~
a.sm:15:5: note: this way to 'Close', and from there to 'Abort', waits for 'pressure'
a.sm:14:5: note: 'smooth' is made of 'pressure' here
a.sm:16:5: note: this way to 'Close', and from there to 'Abort', waits for 'pressure'
a.sm:14:5: note: 'smooth' is made of 'pressure' here
note: let a second sensor, a switch or a limit to T lead to an @abort state too
a.sm:20:18: warning: 'heater' goes on when 'pressure' reads 0, as it does when the sensor is broken [W0903 output-on-zero]
   20 |     smooth < 20: heater = true
      |                  ^~~~~~~~~~~~~
a.sm:14:5: note: step 1: 'smooth' is made of 'pressure' here
a.sm:20:5: note: step 2: this holds when 'pressure' is 0
note: exclude that 'pressure' is 0, or ask a second sensor too
a.sm:21:22: warning: 'heater' goes on when 'temperature' reads 0, as it does when the sensor is broken [W0903 output-on-zero]
   21 |     temperature < 5: heater = true
      |                      ^~~~~~~~~~~~~
a.sm:21:5: note: this holds when 'temperature' is 0
note: exclude that 'temperature' is 0, or ask a second sensor too
3 warnings
