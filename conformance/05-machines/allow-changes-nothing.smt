spec 5.44, 5.50  @allow does not change the behaviour, wherever it is.
analyses on

-- app.sm --
[state_vector]
U64 G
U32 S @allow(unused-allow, "an example") @allow(dead-code, "an example")
F64 x
bool on

[local]
U8 n = 200 @allow(unused-local, "for the next flight") U8 k = 1
U8 m = 2 @read_only @allow(unused-allow, "an example") @allow(unused-local, "an example")

[A] @allow(unused-allow, "an example")
    @allow(unreachable-state, "an example") @safe
.entry
    @allow(dead-store, "an example")
    @allow(dead-code, "an example")
    x = 5
.step
    @allow(dead-code, "an example") k = k + m
    k > 4: @allow(dead-code, "an example") -> B
    else: @allow(dead-code, "an example") @allow(dead-store, "another") x = x + 1

[B] @allow(unused-allow, "an example")
.step
    @allow(dead-code, "an example")
    if x > 6 {
        @allow(dead-code, "an example") x = 1
        on = true
    }
    else if x > 1
    {
        x = 2
    }
    else { @allow(dead-code, "an example") x = 3 }

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert S == 1 and x == 6 and k == 3
G == 1: @assert S == 1 and x == 6 and k == 5
G == 2: @assert S == 2 and x == 2 and not on
G == 3: @assert x == 2
G == 4: x = 7
G == 4: @assert x == 1 and on
G == 4: @stop
