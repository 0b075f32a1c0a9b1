# A finding that is an error: nothing is drawn.
args graph -Werror tank.sm -o tank.svg; ls

-- tank.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
bool armed   @read_only
bool valve
[Idle]
.step
    armed: -> Fill
[Fill]
.entry
    valve = true
.step
    pressure > 800 or pressure < 1: -> Abort
    T > 60000: -> Abort
    pressure > 500 and armed: -> Done
    pressure == 499: -> Fill
.exit
    valve = false
[Abort] @abort
.step
    1 > 2: -> Idle
[Done] @safe
[Lost]
.entry
    -> Idle
-- stdout --
tank.sm
-- stderr --
tank.sm:24:2: error: state 'Lost' is unreachable [W0503 unreachable-state]
   24 | [Lost]
      |  ^~~~ no transition leads here: write -> Lost below a condition of another state
1 error
