# A local that never changes is a constant; also where a script writes it, and a window's size is a constant too.
warn never-written
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[local]
F64 scale = (2)               #! W0207 local 'scale' is never assigned, so it is a constant: mark it @read_only
U16 n     = 20                #! W0207 'n'
F64 limit = scale + 1         #! W0207 'limit'
F64 pi    = 3.14159 @read_only
F64 tuned = 5                 #! W0207 'tuned'
F64 last  = 0
[Hold]
.step
    y = roll_avg(x, n) * pi + last
    last = y
    x > limit + tuned: -> Hold
-- app.ss --
[options]
delta_t 10
[all_states]
G == 10: tuned = 7
G == 50 {
    @assert y >= 0
    @stop
}
