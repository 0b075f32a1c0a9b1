# The chamber lights with a bang: far too much pressure within the first steps.

[all_states]
at 1 s: fire = true
true: @assert S != Burn

[Ignite]
T == 100 ms: igniterLit = true

[Start]
T >= 30 ms {
    pressureA = 45
    pressureB = 45
    pressureC = 45
}
true: @assert T <= 40 ms

[Abort]
true: @assert abortReason == 5 and not oxidizerValve and not fuelValve and not igniter and purgeValve
T == 100 ms: @stop
