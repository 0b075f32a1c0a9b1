# Requirements of another machine are reported as such.
args check a.sm a.rq

-- a.sm --
# Keeps the pressure of a propellant tank in its band by opening a vent valve. Stepped every 10 ms.

[state_vector]
U64   time          @alias G
U32   state         @alias S
F64   tankPressure  @read_only      # psi
bool  valveOpen

[local]
U16  P_WarnThreshold  = 800 @read_only
U16  P_AbortThreshold = P_WarnThreshold + 25 @read_only
U64  counter          = 0

[TankVentControl] @safe
.entry
    counter = 0
.step
    if tankPressure > 775 {
        valveOpen = true
        counter = counter + 1
    }
    else: valveOpen = false
    not (500 < tankPressure < P_AbortThreshold): -> Abort
    counter > 1000 and T > 4000: -> Idle
.exit
    valveOpen = true

[Idle] @safe @allow(output-left-on, "an open vent is the safe position")

[Abort] @safe @allow(output-left-on, "an open vent is the safe position")
-- a.rq --
# requirements
R1 "no pyro on the pad"      never S == Pad and (drogue or main)
R2 "no main before drogue"   never Main before Drogue
R3 "pressure leads to main"  always p > 100 leads to main within 100 ms
R4 "drogue stays"            always S == Main implies drogue and main
R5 "through drogue"          never Main after Pad without Drogue
-- stderr --
a.rq:2:41: error: unknown state 'Pad' [E0501]
    2 | R1 "no pyro on the pad"      never S == Pad and (drogue or main)
      |                                         ^~~
note: 'a.sm' has none of the names that these requirements use; are they for another machine?
a.rq:2:50: error: unknown element 'drogue' [E0204]
    2 | R1 "no pyro on the pad"      never S == Pad and (drogue or main)
      |                                                  ^~~~~~
a.rq:2:60: error: unknown element 'main' [E0204]
    2 | R1 "no pyro on the pad"      never S == Pad and (drogue or main)
      |                                                            ^~~~
a.rq:3:36: error: unknown state 'Main' [E0501]
    3 | R2 "no main before drogue"   never Main before Drogue
      |                                    ^~~~
a.rq:3:48: error: unknown state 'Drogue' [E0501]
    3 | R2 "no main before drogue"   never Main before Drogue
      |                                                ^~~~~~
a.rq:4:37: error: unknown element 'p' [E0204]
    4 | R3 "pressure leads to main"  always p > 100 leads to main within 100 ms
      |                                     ^
6 errors
-- exit --
1
