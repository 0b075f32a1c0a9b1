spec 8.10, 8.11   A script that uses no name of the machine probably belongs to another one: the first message says so.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 1              #! E0204 unknown element 'p'
T > 5: @assert q           #! E0204 'q'
[Burn]                     #! E0501
G == 20: @stop
