spec 5.54  A command is an element, not a local, a state or a statement; the annotation has no value.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @command 3             #! E0330 the number 3
F64 b @command @command      #! E0361 '@command'
bool c
[local]
U8 n = 0 @command            #! E0362 '@command'
[A] @command                 #! E0376 '@command'
.step
    c = a + n > b
    @command                 #! E0340 '@command'
    c: @command              #! E0340 '@command'
    -> B
[B] @safe
.step
    c = false
