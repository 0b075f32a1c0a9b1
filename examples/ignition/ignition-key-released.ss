# The key is let go of in the purge, with the igniter on, with the valves just open, and in the burn. Each time
# everything is shut in that same step, and a new start is possible.

[local]
F64 chamber = 0

[all_states]
true: fire = 1 s <= G < 1.5 s or 10 s <= G < 11.3 s or 20 s <= G < 22 s or 30 s <= G < 33 s

at 1.49 s: @assert S == Purge
at 11.29 s: @assert S == Ignite
at 32.99 s: @assert S == Burn

[Ignite]
G < 21.7 s: igniterLit = false
G > 21.7 s: igniterLit = true

# The third time the chamber stays cold until the key is let go of, the fourth time it lights.
[Start]
after 30 s: chamber = 20
else: chamber = 3
true: @assert abortReason == 0 or not fire

[Abort]
true: chamber = 0
true: @assert abortReason == 1 and not igniter and not oxidizerValve and not fuelValve
T < 5 s: @assert purgeValve
true: @assert T <= 5 s

[Idle]
true: @assert not igniter and not oxidizerValve and not fuelValve and not purgeValve

[all_states]
true {
    pressureA = chamber
    pressureB = chamber
    pressureC = chamber
}
at 1.52 s: @assert S == Abort
at 11.32 s: @assert S == Abort
at 22.01 s: @assert S == Abort
at 33.01 s: @assert S == Abort
at 40 s: @assert S == Idle
at 40 s: @stop
