spec 4.13, 3.3  A truth compared with a number, from either side.

-- app.sm --
[state_vector]
U64 G
U32 S
bool on
U8 r
U8 q

[Run]
.step
    r = (0.5 < on) + 2 * (0.5 > on) + 4 * (1 <= on) + 8 * (0 >= on) + 16 * (0 < on) + 32 * (1 > on)
    q = (on < 0.5) + 2 * (on > 0.5) + 4 * (on <= 1) + 8 * (on >= 0) + 16 * (on < 0) + 32 * (on > 1)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    on = true
    @assert r == 21
    @assert q == 14
}
G == 1 {
    on = false
    @assert r == 42
    @assert q == 13
}
G == 2 {
    on = 7
    @assert r == 21
    @assert q == 14
    @stop
}
