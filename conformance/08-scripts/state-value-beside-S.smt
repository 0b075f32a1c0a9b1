spec 8.44  `S == state Burn` compares twice, which is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
S == state Burn: p = 1      #! E0763 write Burn
state A != S: p = 1         #! E0763 write A
state Bern: p = 1           #! E0501
S == Burn: @stop
