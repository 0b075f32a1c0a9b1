spec 5.66  The uses of definitions have a limit.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
d0 = x
d1 = d0 + d0
d2 = d1 + d1
d3 = d2 + d2
d4 = d3 + d3
d5 = d4 + d4
d6 = d5 + d5
d7 = d6 + d6
d8 = d7 + d7
d9 = d8 + d8
d10 = d9 + d9
d11 = d10 + d10
d12 = d11 + d11
d13 = d12 + d12
d14 = d13 + d13
d15 = d14 + d14
d16 = d15 + d15      #! E0226
[Run]
.entry
    x = d15 + d14
.step
    x = d16
    x = d3 + d16         # the limit is reported once
