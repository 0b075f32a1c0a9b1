# Both valves are open and the chamber does not light: 400 ms later everything is shut, before the stand is full of propellant.

[all_states]
at 1 s: fire = true

[Ignite]
T == 100 ms: igniterLit = true

[Start]
true {
    pressureA = 3
    pressureB = 3
    pressureC = 3
}
T < 400 ms: @assert oxidizerValve and abortReason == 0
true: @assert T <= 400 ms

[Abort]
true: @assert abortReason == 3 and not oxidizerValve and not fuelValve and not igniter and purgeValve
T == 6 s: @stop
