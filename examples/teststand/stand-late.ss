# What takes too long ends in Abort: a line that does not get cold, an igniter that does not light, an engine that does not.

[all_states]
at 0 {
    chamberPressureA = 1
    chamberPressureB = 1
    tankPressure     = 40
    lineTemperature  = 293
    key              = true
}
at 14 s: @assert S == Chill
at 14.2 s {
    @assert S == Abort and abortReason == 3
    @assert ventValve and purgeValve and not chillValve
}
# The key is let go: back to Idle when the tank is empty, and nothing starts by itself.
at 15 s {
    tankPressure    = 2
    lineTemperature = 95
}
at 20 s: @assert S == Abort
at 20 s: key = false
at 20.1 s: @assert S == Idle and abortReason == 3 and not ventValve
at 21 s: key = true
at 24 s: @assert S == Idle
at 25 s: tankPressure = 40
at 26 s: @assert S == Ignite
at 27.5 s {
    @assert S == Abort
    @assert abortReason == 4 and not igniter
}
at 28 s: key = false
# A tank that reads 0 is not empty: its sensor is broken, and the vent stays open.
at 28 s: tankPressure = 0
at 32.5 s: @assert S == Abort and ventValve
at 32.5 s: tankPressure = 2
at 33.2 s: @assert S == Idle
at 33.3 s {
    key          = true
    tankPressure = 40
}
G > 30 s and S == Ignite: flame = true
at 36.5 s: @assert S == Abort and abortReason == 5 and not oxidizerValve and not fuelValve and not igniter
at 36.5 s: @stop
