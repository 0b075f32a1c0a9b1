# A burn as it should be. The key is turned at 1 s and let go of long after the end.

[define]
rise = max(0, T - 100) / 5        # bar, while the chamber lights
burn = min(20, 8 + T / 20)        # bar

[local]
F64 chamber = 0           # bar
F64 spread = 0            # between the sensors

[all_states]
at 1 s: fire = true
at 12 s: fire = false
at 500 ms: @assert S == Idle
true: @assert abortReason == 0
# Fuel never flows without oxidizer, but for the 100 ms at the end; nitrogen never flows into a burning chamber.
fuelValve and S != Shutdown: @assert oxidizerValve
oxidizerValve: @assert not purgeValve

[Idle]
true: @assert not igniter and not oxidizerValve and not fuelValve and not purgeValve

[Purge]
T < 1 s: @assert purgeValve and not igniter and not oxidizerValve and not fuelValve
T == 1 s: @assert not purgeValve

[Ignite]
T == 300 ms: igniterLit = true
T < 500 ms: @assert igniter and not oxidizerValve and not fuelValve and not purgeValve

# The chamber lights 150 ms after the oxidizer valve has opened.
[Start]
true: chamber = rise
true: spread = 0.2
T < 60 ms: @assert oxidizerValve and not fuelValve and igniter
T == 60 ms: @assert oxidizerValve and fuelValve and igniter
true: @assert T <= 150 ms

[Burn]
T == 0: @assert chamber >= 8         # measured in the step before
true: chamber = burn
true: @assert not igniter and fuelValve
T < 4 s: @assert oxidizerValve and not purgeValve
true: @assert T <= 4 s

[Shutdown]
true: chamber = max(0, 20 - T / 10)
true: spread = 0
true: @assert not oxidizerValve and not igniter
T < 100 ms: @assert fuelValve and not purgeValve
T >= 100 ms: @assert not fuelValve and purgeValve

[all_states]
true {
    pressureA = chamber
    pressureB = chamber + spread
    pressureC = chamber - spread
}
at 1.9 s: @assert S == Purge
at 2.5 s: @assert S == Ignite
at 6.5 s: @assert S == Burn
at 8 s: @assert S == Shutdown
at 11.99 s: @assert S == Shutdown
at 12.1 s: @assert S == Idle
at 12.1 s: @stop
