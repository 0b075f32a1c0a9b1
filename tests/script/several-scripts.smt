# Each script of a case starts with a new machine.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 last = 4
[Idle]
.step
    last = last + x
    -> Away
[Away]
-- one.ss --
[options]
delta_t 1
[Idle]
true {
    x = 1
    @assert last == 5
}
[Away]
true: @stop
-- two.ss --
[options]
delta_t 1
[Idle]
x == 0 and last == 4 and G == 0 {
    @assert last == 4
    @stop
}
