# A burn as it should be. The key is turned at 1 s and let go of long after the end.

[options]
delta_t 10

[all_states]
G == 1000: fire = true
G == 12000: fire = false
G == 500: @assert S == Idle
true: @assert abortReason == 0
# Fuel never flows without oxidizer, but for the 100 ms at the end; nitrogen never flows into a burning chamber.
fuelValve and S != Shutdown: @assert oxidizerValve
oxidizerValve: @assert not purgeValve

[Idle]
true: @assert not igniter and not oxidizerValve and not fuelValve and not purgeValve

[Purge]
T < 1000: @assert purgeValve and not igniter and not oxidizerValve and not fuelValve
T == 1000: @assert not purgeValve

[Ignite]
T == 300: igniterLit = true
T < 500: @assert igniter and not oxidizerValve and not fuelValve and not purgeValve

# The chamber lights 150 ms after the oxidizer valve has opened.
[Start]
true: pressureA = max(0, T - 100) / 5
true: pressureB = max(0, T - 100) / 5 + 0.2
true: pressureC = max(0, T - 100) / 5 - 0.2
T < 60: @assert oxidizerValve and not fuelValve and igniter
T == 60: @assert oxidizerValve and fuelValve and igniter
T < 140: @assert S == Start
true: @assert T <= 150

[Burn]
true {
    pressureA = min(20, 8 + T / 20)
    pressureB = min(20, 8 + T / 20) + 0.2
    pressureC = min(20, 8 + T / 20) - 0.2
}
true: @assert not igniter and fuelValve
T < 4000: @assert oxidizerValve and not purgeValve
true: @assert T <= 4000

[Shutdown]
true {
    pressureA = max(0, 20 - T / 10)
    pressureB = max(0, 20 - T / 10)
    pressureC = max(0, 20 - T / 10)
}
true: @assert not oxidizerValve and not igniter
T < 100: @assert fuelValve and not purgeValve
T >= 100: @assert not fuelValve and purgeValve

[all_states]
G ==  1900: @assert S == Purge
G ==  2500: @assert S == Ignite
G ==  6500: @assert S == Burn
G ==  8000: @assert S == Shutdown
G == 11990: @assert S == Shutdown
G == 12100 {
    @assert S == Idle
    @stop
}
