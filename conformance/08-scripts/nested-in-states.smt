spec 8.46  Conditionals of a state's section nest, too.

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
[Burn]
T >= 20 {
    T == 20: p = 1
    else if T == 30 {
        p = 2
        from 60 to 70: p = 90
        at 70: p = 3
    }
    else { every 40: p = p + 10 }
}
T == 10: @assert p == 0
T == 20: @assert p == 1
T == 30: @assert p == 3
T == 40: @assert p == 13
T == 50: @assert p == 13
T == 60 { @assert p == 13
          @stop }
