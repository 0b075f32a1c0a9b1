spec 5.45  Marks of states have no place on variables nor among statements, other annotations none behind a header.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @abort              #! E0375 [Name] @abort
F64 b
[local]
U8 n = 0 @safe            #! E0375 [Name] @safe
U8 o = 0 @swap            #! E0375 [Name] @swap
[A] @read_only            #! E0376 '@read_only'
.step
    b = a + n + o
    @safe                 #! E0340 [Name] @safe
    b > 1: @abort         #! E0340 [Name] @abort
    @swap                 #! E0340 [Name] @swap
[B] @range 0 1            #! E0376 '@range'
.step
    -> A
[C] @alias X @safe        #! E0376 '@alias'
[D] @safe
