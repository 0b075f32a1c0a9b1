spec 1.9  orbit, note, iffy, truest, elsewhere and U8x are names, although they begin with words of the language.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 orbit
F64 note
F64 iffy
F64 truest
F64 elsewhere
F64 U8x
F64 android
F64 F64F64

[Run]
.step
    orbit = 1
    note = 2
    iffy = 3
    truest = 4
    elsewhere = 5
    U8x = 6
    android = 7
    F64F64 = 8

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert orbit == 1
    @assert note == 2
    @assert iffy == 3
    @assert truest == 4
    @assert elsewhere == 5
    @assert U8x == 6
    @assert android == 7
    @assert F64F64 == 8
    @stop
}
