spec 8.47  Asserts of inner conditionals are judged in the order of the file.
expect fail

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
at 10 {
    true: @assert n == 0
    @fail "second"      #! E0755 second
    true: @fail "third"
}
at 20: @stop
