spec 5.63, 5.67  A definition shares the names of elements and locals.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 y = 1
[define]
x = 2               #! E0201 it is an element
y = 3               #! E0201 it is a local
T = 4               #! E0203
z = 5
z = 6               #! E0201 it is a definition
unused = x > 3      #! W0212 'unused' is never used
[Run]
.step
    z = 7           #! E0223 'z' cannot be assigned
    x = y + z + zz  #! E0204
    x = z(3)        #! E0218
