spec 5.41  However deep.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[A]
.step
    -> B
.exit
    if x > 1 {
        x = 2
        if x > 3: x = 1
        else: -> A   #! E0504
    }

[B]
