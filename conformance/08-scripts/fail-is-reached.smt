spec 8.32  @fail ends the script as failed after the step, with its text and requirement.
expect fail
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
bool open
[Hold]
.step
    open = x > 5
    x == 100: -> Vent
[Vent]
.step
    open = false
-- app.ss --
[options]
delta_t 10
[all_states]
G == 10: x = 100
G == 50: @stop
[Vent]
T == 10: @fail "vented" @req R1       #! E0755 reached '@fail' in step 4 (G = 30, state Vent): vented (R1)
