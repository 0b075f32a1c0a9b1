# Both valves are open and the chamber does not light: 400 ms later everything is shut, before the stand is full of propellant.

[options]
delta_t 10

[all_states]
G == 1000: fire = true

[Ignite]
T == 100: igniterLit = true

[Start]
true {
    pressureA = 3
    pressureB = 3
    pressureC = 3
}
T < 400: @assert oxidizerValve and abortReason == 0
true: @assert T <= 400

[Abort]
true: @assert abortReason == 3 and not oxidizerValve and not fuelValve and not igniter and purgeValve
T == 6000: @stop
