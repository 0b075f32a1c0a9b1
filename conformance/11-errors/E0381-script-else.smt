spec 8.7   A script has no else.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 600
else: p = 500       #! E0381 'else'
G == 100: @stop
