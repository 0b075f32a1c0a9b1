# A window in [all_states] or in a definition is reported only if no state and no use needs it.
warn no-unreachable-state no-dead-code no-constant-guard no-after-transition
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
high = roll_min(p, 3) > 5
low = roll_max(p, 3) < 2              #! W0209
[all_states] @except Abort
.step
    held(p > 50, 3 steps): -> Abort        #! W0425
[Run]
.step
    high: x = 1
    T > 1000: -> Abort
[Lost]
.step
    high: x = 2
    low: x = 3
[Abort]
