# What takes too long ends in Abort: a line that does not get cold, an igniter that does not light, an engine that does not.

[all_states]
G == 0 {
    chamberPressureA = 1
    chamberPressureB = 1
    tankPressure     = 40
    lineTemperature  = 293
    key              = true
}
G == 14 s: @assert S == Chill
G == 14.2 s {
    @assert S == Abort and abortReason == 3
    @assert ventValve and purgeValve and not chillValve
}
# The key is let go: back to Idle when the tank is empty, and nothing starts by itself.
G == 15 s {
    tankPressure    = 2
    lineTemperature = 95
}
G == 20 s: @assert S == Abort
G == 20 s: key = false
G == 20.1 s: @assert S == Idle and abortReason == 3 and not ventValve
G == 21 s: key = true
G == 24 s: @assert S == Idle
G == 25 s: tankPressure = 40
G == 26 s: @assert S == Ignite
G == 27.5 s {
    @assert S == Abort
    @assert abortReason == 4 and not igniter
}
G == 28 s: key = false
# A tank that reads 0 is not empty: its sensor is broken, and the vent stays open.
G == 28 s: tankPressure = 0
G == 32.5 s: @assert S == Abort and ventValve
G == 32.5 s: tankPressure = 2
G == 33.2 s: @assert S == Idle
G == 33.3 s {
    key          = true
    tankPressure = 40
}
G > 30 s and S == Ignite: flame = true
G == 36.5 s {
    @assert S == Abort
    @assert abortReason == 5 and not oxidizerValve and not fuelValve and not igniter
    @stop
}
