# The key is let go of in the purge, with the igniter on, with the valves just open, and in the burn. Each time
# everything is shut in that same step, and a new start is possible.

[options]
delta_t 10

[all_states]
G ==  1000: fire = true
G ==  1500: fire = false
G == 10000: fire = true
G == 11300: fire = false
G == 20000: fire = true
G == 22000: fire = false
G == 30000: fire = true
G == 33000: fire = false

G ==  1490: @assert S == Purge
G == 11290: @assert S == Ignite
G == 32990: @assert S == Burn

[Ignite]
G < 21700: igniterLit = false
G > 21700: igniterLit = true

# The third time the chamber stays cold until the key is let go of, the fourth time it lights.
[Start]
G < 30000 {
    pressureA = 3
    pressureB = 3
    pressureC = 3
}
G > 30000 {
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
T < 5000: @assert S == Abort and purgeValve
true: @assert T <= 5000

[Idle]
true: @assert not igniter and not oxidizerValve and not fuelValve and not purgeValve

[all_states]
G ==  1520: @assert S == Abort
G == 11320: @assert S == Abort
G == 22010: @assert S == Abort
G == 33010: @assert S == Abort
G == 40000 {
    @assert S == Idle
    @stop
}
