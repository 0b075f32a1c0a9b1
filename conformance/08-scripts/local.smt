spec 8.23, 8.26  A script declares variables of every type, in any number of sections, which inputs assign and everything reads.
on   ref vm c

-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure @alias p
bool valveOpen

[local]
U8 n = 3
F64 limit = 8 @read_only

[Hold]
.step
    valveOpen = pressure > limit + n - n
    pressure > 100: -> Vent

[Vent]

-- app.ss --
[options]
delta_t 10

[local]
U8   big   = 300
F64  twice = 2 * big + n + limit
bool done  = false
F32  tenth = 0.1 @read_only
I64  low   = -9e30

[Hold]
G == 0: @assert big == 255 and twice == 521 and not done and low == -9223372036854775808
true {
    small = small - 3.5
    pressure = twice / 10 + small
    done = pressure < 53
}
done: @assert small == 0 and tenth != 0.1 and tenth == 0.10000000149011612

[local]
U16 small = 9

[all_states]
done: @stop
