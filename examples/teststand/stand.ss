# A firing as it should be: key at 3 s, cold at 7 s, a burn of four seconds, the key let go at 15 s.

[all_states]
at 0 {
    chamberPressureA = 1
    chamberPressureB = 1
    tankPressure     = 40
    lineTemperature  = 293
}
at 3 s: key = true
from 3 s to 7 s: lineTemperature = max(95, lineTemperature - 0.8)
igniter and T > 200 ms: flame = true
fuelValve and T > 80 ms {
    chamberPressureA = 20
    chamberPressureB = 20.3
}
true: flow = 0.9 * oxidizerValve
not fuelValve {
    chamberPressureA = 1
    chamberPressureB = 1
}
not fuelValve and not igniter: flame = false
at 9 s: chamberPressureB = 45             # one wild sample in the burn
at 15 s: key = false
true {
    @assert abortReason == 0 and not ventValve
    @assert not fuelValve or oxidizerValve or S == Shutdown
    @assert not chillValve or S == Chill
}

[Idle]
true: @assert G <= 3 s or G > 14.9 s

[Chill]
true: @assert chillValve or lineTemperature == 95
true: @assert not igniter and not oxidizerValve and not fuelValve

[Ignite]
T < 300 ms: @assert igniter and not oxidizerValve and not fuelValve

[Start]
T == 0: @assert igniter and oxidizerValve and not fuelValve

[Burn]
T < 4 s: @assert oxidizerValve and fuelValve and not igniter and not purgeValve

[Shutdown]
T == 0: @assert not oxidizerValve and fuelValve
T >= 100 ms: @assert not fuelValve and purgeValve

[all_states]
at 9.5 s: @assert S == Burn
at 14 s: @assert S == Shutdown
at 16 s: @assert S == Idle and not purgeValve
at 16 s: @stop
