spec 5.61  Each line is a name, = and an expression.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
a = x > 3 b = 2     #! E0330
F64 c = 3           #! E0391 has no type
d                   #! E0392 after 'd'
x > 3: x = 2        #! E0392
5 = x               #! E0391
e =                 #! E0312
f = x > 1
[Run]
.step
    f and a and c: x = 5
