spec 8.7   Conditionals of a script do not nest.

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
G == 0 {
    p == 0: p = 600     #! E0382 nest
}
G == 100: p > 5: @stop  #! E0382 nest
