spec 1.30  Within parentheses a line end is a blank, before and after operators, and in calls.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
F64 z

[Run]
.step
    x = (1
         + 2
         +
         3)
    y = max(
        4
        ,
        5)
    (x == 6
       and
       y == 5): z = 7

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert (x
 == 6)
    @assert y == 5
    @assert z == 7
    @stop
}
