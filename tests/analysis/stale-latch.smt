# A latch and an extreme that nothing resets before the state that reads them begins again.  The second run opens the valve without a flame, and the
# second flight fires the charge on the first one's height.
warn no-all stale-latch

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time      @alias G
U32  state     @alias S
bool key       @read_only @command
bool launch    @read_only
bool flame     @read_only
F32  altitude  @read_only @range -50 3000
bool igniter
bool valve
bool charge

[local]
bool lit     = false
F32  highest = 0

[Idle] @safe
.step
    key: -> Ignite
    launch: -> Ascent

[Ignite]
.entry
    igniter = true
.step
    held(flame, 5 steps): lit = true
    lit and T >= 500 ms: -> Burn              #! W0915 when 'Ignite' begins again, 'lit' is still 1, and the machine goes to 'Burn'
    T > 2 s: -> Idle
.exit
    igniter = false

[Burn]
.entry
    valve = true
.step
    T > 4 s: -> Idle
.exit
    valve = false

[Ascent]
.step
    highest = max(highest, altitude)
    altitude < highest - 10: -> Drogue        #! W0915 when 'Ascent' begins again, 'highest' is still
    T > 40 s: -> Drogue

[Drogue]
.entry
    charge = true
.step
    T > 1 s: -> Idle
.exit
    charge = false
