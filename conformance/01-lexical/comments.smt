spec 1.8  A comment goes from # to the end of the line and separates like a blank.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x#x
F64 y  # y = 5 # again

[Run]
.step
    # x = 7
    x = 1# + 5
    #
    ##
    y = 2 # -> Nowhere

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @assert y == 2   # == 3
    @stop
}
