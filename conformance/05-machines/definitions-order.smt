spec 5.62  A definition uses those above it only.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
a = x + b           #! E0225 'a' uses 'b', which is defined below it
b = 1 + b           #! E0224 'b' uses itself
c = x + d           #! E0225
[Run]
.step
    x = a + b + c
[define]
d = 2
