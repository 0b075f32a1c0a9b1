spec 2.25  Names, *, /, powers, parentheses and 1; no blanks.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m/s^2
F64 b @unit kg*m/s^2
F64 c @unit J/(kg*K) @read_only
F64 d @unit 1
F64 e @unit s^-1
F64 f @unit V/Hz^0.5
F64 g @unit (m/s)^2
F64 h @unit 1/s # a comment
F64 i @unit m@read_only

[Run] @safe
.step
    a = c + d + i
    b = e
    f = g + h

-- app.ss --
[options]
delta_t 10

[all_states]
G == 0: c = 2
G == 0 {
    @assert a == 2
    @stop
}
