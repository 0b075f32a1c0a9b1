# The chamber lights with a bang: far too much pressure within the first steps.

[options]
delta_t 10

[all_states]
G == 1000: fire = true
true: @assert S != Burn

[Ignite]
T == 100: igniterLit = true

[Start]
T >= 30 {
    pressureA = 45
    pressureB = 45
    pressureC = 45
}
true: @assert T <= 40

[Abort]
true: @assert abortReason == 5 and not oxidizerValve and not fuelValve and not igniter and purgeValve
T == 100: @stop
