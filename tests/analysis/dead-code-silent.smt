spec 6.10   What is executed, and what needs no second word.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool valve
[local]
U8 mode = 0
[A]
.step
    p > 10: -> B
    p < 10: -> C
    valve = true
    q > 3 { q > 5: -> B }
    else: -> C
    valve = false
[B]
.step
    p > 3: -> A
    -> C
    -> Lost                              #! W0501
    valve = false
.exit
    valve = false
[C]
.entry
    mode = 1
    mode == 1: -> A                      #! W0509
    valve = true
.step
    valve = false
[Lost]
