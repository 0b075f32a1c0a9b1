spec 8.10  G cannot be written under the name of its element either.

-- app.sm --
[state_vector]
U64 time @alias G
U32 mode @alias S

[A]

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: time = 5   #! E0214
G == 0: mode = 5   #! E0215
G == 3: @stop
