spec 5.10   An initial value uses no later local; the message offers the order.
-- app.sm --
[state_vector]
U64 G
U32 S
[local]
U16 abort = warn + 25         #! E0408 'warn' is declared here
U16 warn  = 800
U16 both  = abort + warn
[Hold]
.step
    warn = abort + both
