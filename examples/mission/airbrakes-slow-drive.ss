# The drive is slow and the order swings, but it follows: no reason to give up.

[all_states]
true {
    mayBrake = true
    altitude = 1000
    velocity = 160 + 12 * (floor(G / 2000) * 2000 + 1 s > G)
}
true: brakePosition = brakePosition + clamp(brakeOrder - brakePosition, -0.012, 0.012)
true: @assert S != Jammed
at 20 s: @stop
