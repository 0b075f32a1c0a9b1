# A burn as it should be. The key is turned at 1 s and let go of long after the end.

[define]
rise = max(0, T - 100) / 5        # bar, while the chamber lights
burn = min(20, 8 + T / 20)        # bar

[all_states]
G == 1 s: fire = true
G == 12 s: fire = false
G == 500 ms: @assert S == Idle
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
true {
    pressureA = rise
    pressureB = rise + 0.2
    pressureC = rise - 0.2
}
T < 60 ms: @assert oxidizerValve and not fuelValve and igniter
T == 60 ms: @assert oxidizerValve and fuelValve and igniter
T < 140 ms: @assert S == Start
true: @assert T <= 150 ms

[Burn]
true {
    pressureA = burn
    pressureB = burn + 0.2
    pressureC = burn - 0.2
}
true: @assert not igniter and fuelValve
T < 4 s: @assert oxidizerValve and not purgeValve
true: @assert T <= 4 s

[Shutdown]
true {
    pressureA = max(0, 20 - T / 10)
    pressureB = max(0, 20 - T / 10)
    pressureC = max(0, 20 - T / 10)
}
true: @assert not oxidizerValve and not igniter
T < 100 ms: @assert fuelValve and not purgeValve
T >= 100 ms: @assert not fuelValve and purgeValve

[all_states]
G == 1.9 s: @assert S == Purge
G == 2.5 s: @assert S == Ignite
G == 6.5 s: @assert S == Burn
G == 8 s: @assert S == Shutdown
G == 11.99 s: @assert S == Shutdown
G == 12.1 s {
    @assert S == Idle
    @stop
}
