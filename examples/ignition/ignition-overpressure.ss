# The pressure rises above what is allowed, in the middle of the burn.

[options]
delta_t 10

[all_states]
G == 1000: fire = true

[Ignite]
T == 100: igniterLit = true

[Start]
true {
    pressureA = 10
    pressureB = 10
    pressureC = 10
}

[Burn]
true {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
T >= 1500 {
    pressureA = 30
    pressureB = 31
    pressureC = 29
}
true: @assert T <= 1510

[all_states]
2700 < G < 4100: @assert S == Burn and fuelValve

[Abort]
true: @assert abortReason == 5 and not oxidizerValve and not fuelValve and purgeValve
T == 100: @stop
