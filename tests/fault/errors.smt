# Mistakes of every stage: what reports them needs memory too.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 preßure
F64 pressure
[local]
U8 a = b + 1
U8 pressure = 3
[A]
.step
    pressure = presure +
    pressure >: -> B
    x = 1 {
    -> Nowhere
[A]
