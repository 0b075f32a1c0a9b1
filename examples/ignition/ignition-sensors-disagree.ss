# Two sensors fail, and no two of the three agree any more.

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

# For a second B alone is wrong, which is no reason to stop.
[Burn]
true {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
T >= 1000: pressureB = 27
T >= 2000: pressureC = 14
T < 2050: @assert S == 5 and fuelValve
true: @assert T <= 2120

[Abort]
true: @assert abortReason == 6 and not oxidizerValve and not fuelValve and purgeValve
T == 100: @stop
