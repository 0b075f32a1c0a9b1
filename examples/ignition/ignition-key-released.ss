# The key is let go of in the purge, with the igniter on, with the valves just open, and in the burn. Each time
# everything is shut in that same step, and a new start is possible.

[all_states]
G == 1 s: fire = true
G == 1.5 s: fire = false
G == 10 s: fire = true
G == 11.3 s: fire = false
G == 20 s: fire = true
G == 22 s: fire = false
G == 30 s: fire = true
G == 33 s: fire = false

G == 1.49 s: @assert S == Purge
G == 11.29 s: @assert S == Ignite
G == 32.99 s: @assert S == Burn

[Ignite]
G < 21.7 s: igniterLit = false
G > 21.7 s: igniterLit = true

# The third time the chamber stays cold until the key is let go of, the fourth time it lights.
[Start]
G < 30 s {
    pressureA = 3
    pressureB = 3
    pressureC = 3
}
G > 30 s {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
true: @assert abortReason == 0 or not fire

[Abort]
true {
    pressureA = 0
    pressureB = 0
    pressureC = 0
}
true: @assert abortReason == 1 and not igniter and not oxidizerValve and not fuelValve
T < 5 s: @assert S == Abort and purgeValve
true: @assert T <= 5 s

[Idle]
true: @assert not igniter and not oxidizerValve and not fuelValve and not purgeValve

[all_states]
G == 1.52 s: @assert S == Abort
G == 11.32 s: @assert S == Abort
G == 22.01 s: @assert S == Abort
G == 33.01 s: @assert S == Abort
G == 40 s {
    @assert S == Idle
    @stop
}
