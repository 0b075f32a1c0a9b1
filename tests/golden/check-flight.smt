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
F64  smooth = 30
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
a.sm:10:2: warning: state 'Burn' cannot abort if 'pressure' sticks, for example at 1: no transition to an @abort state is left [W0902 abort-single-sensor]
   10 | [Burn]
      |  ^~~~
a.sm:15:5: note: this transition to 'Close', and from there to 'Abort', depends on 'pressure'
a.sm:14:5: note: 'smooth' is computed from 'pressure' here
a.sm:16:5: note: this transition to 'Close', and from there to 'Abort', depends on 'pressure'
a.sm:14:5: note: 'smooth' is computed from 'pressure' here
note: let a second sensor, a switch or a time limit with T lead to an @abort state, too
a.sm:20:18: warning: 'pressure' alone switches on 'heater' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   20 |     smooth < 20: heater = true
      |                  ^~~~~~~~~~~~~
note: for example in 'Burn': 'pressure' reads 30.5, then 0; this happens in step 2 after that
note: require that 'pressure' is plausible, or that a second sensor agrees
a.sm:21:22: warning: 'temperature' alone switches on 'heater' when it reads 0, as a broken sensor can [W0903 output-on-zero]
   21 |     temperature < 5: heater = true
      |                      ^~~~~~~~~~~~~
note: for example in 'Burn': 'temperature' reads 125, then 0; this happens in step 1 after that
note: require that 'temperature' is plausible, or that a second sensor agrees
3 warnings
