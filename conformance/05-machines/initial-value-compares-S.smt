spec 5.10, 3.30  An initial value cannot compare S with a state. One error is enough.

-- app.sm --
[state_vector]
U64 G
U32 mode @alias S
F64 x
[local]
bool in_run = S == Run          #! E0406 'S'
bool out    = Idle != mode      #! E0406 'mode'
[Idle]
.step
    x = in_run + out
[Run]
