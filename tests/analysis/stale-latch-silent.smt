# Latches that decide nothing with a former visit: reset where the machine waits; set before the state
# begins; one that chooses between two ways, so that the second run leaves out what has been done ('primed').
warn no-all stale-latch

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time     @alias G
U32  state    @alias S
bool key      @read_only @command
bool test     @read_only @command
bool flame    @read_only
F32  chamber  @read_only @range 0 60
bool igniter
bool valve
bool pump

[local]
bool lit    = false
bool warm   = false
bool tested = false
bool primed = false

[Idle] @safe
.entry
    warm = false
    lit = false
.step
    test: tested = true
    key and primed: -> Ignite
    key: -> Prime

[Prime]
.entry
    pump = true
.step
    T > 1 s: primed = true
    T > 2 s: -> Idle
.exit
    pump = false

[Ignite]
.entry
    igniter = true
.step
    held(flame, 5 steps): lit = true
    lit and tested and T >= 500 ms: -> Burn
    T > 2 s: -> Idle
.exit
    igniter = false

[Burn]
.entry
    valve = true
.step
    chamber > 8: warm = true
    warm and T > 4 s: -> Idle
    T > 9 s: -> Idle
.exit
    valve = false
