spec 5.51  @allow covers its declaration, its state's section, or its statement and everything inside it.
analyses on

-- app.sv --
[R]
U64 G
U32 S
F64 x
F64 a
F64 b @allow(unused-element, "for the ground only")
F64 c @allow(alias-own-name, "for all machines")
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 a                                     #! W0203 'a'
F64 b
F64 c @alias c

[local]
U8 d = 0                                  #! W0204 'd'
U8 e = 0 @allow(unused-local, "spare")
U8 f = 0                                  #! W0204 'f'

[A] @allow(empty-braces, "to be filled in")
.step
    x > 1 { }
    x > 2: -> A
    x = 300 + c
.exit
    x > 1 { }

[B] @allow(unreachable-state, "for the next flight")
.step
    x > 1 { }                             #! W0502
    @allow(empty-braces, "to be filled in")
    x > 2 {
        x > 3 { }
    }
    else if x > 4 {
        x > 5 { }
    }
    else if x > 6: x > 7 { }
    else {
        x > 8 { }
    }
    x > 1 { }                             #! W0502
    x > 1: @allow(empty-braces, "to be filled in") x > 2 { }
    else: x > 3 { }
    x > 1 { @allow(empty-braces, "to be filled in") x > 2 { } }
    else: x > 3 { }                       #! W0502

[C]                                       #! W0503 'C'
.step
    -> C
    @allow(after-transition, "for the next flight") x = 1
    x = 2
