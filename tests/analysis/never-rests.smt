# Cycles of states that are left without a condition.
warn no-all never-rests ping-pong
-- app.sm --
[state_vector]
U64  G
U32  S
bool go @read_only
bool lamp
[Off] @safe
.step
    go: -> Flash
[Flash]
.entry
    lamp = true
.step
    -> Gap                  #! W0927 the machine changes its state at every step, beginning with 'Flash': no transition of this cycle has a condition
[Gap]
.entry
    lamp = false
.step
    -> Dark
[Dark]
.step
    -> Flash
