# What takes too long ends in Abort: a line that does not get cold, an igniter that does not light, an engine that does not.

[options]
delta_t 10

[all_states]
G == 0 {
    chamberPressureA = 1
    chamberPressureB = 1
    tankPressure     = 40
    lineTemperature  = 293
    key              = true
}
G == 14000: @assert S == Chill
G == 14200 {
    @assert S == Abort and abortReason == 3
    @assert ventValve and purgeValve and not chillValve
}
# The key is let go: back to Idle when the tank is empty, and nothing starts by itself.
G == 15000 {
    tankPressure    = 2
    lineTemperature = 95
}
G == 20000: @assert S == Abort
G == 20000: key = false
G == 20100: @assert S == Idle and abortReason == 3 and not ventValve
G == 21000: key = true
G == 24000: @assert S == Idle
G == 25000: tankPressure = 40
G == 26000: @assert S == Ignite
G == 27500 {
    @assert S == Abort
    @assert abortReason == 4 and not igniter
}
G == 28000: key = false
# A tank that reads 0 is not empty: its sensor is broken, and the vent stays open.
G == 28000: tankPressure = 0
G == 32500: @assert S == Abort and ventValve
G == 32500: tankPressure = 2
G == 33200: @assert S == Idle
G == 33300 {
    key          = true
    tankPressure = 40
}
G > 30000 and S == Ignite: flame = true
G == 36500 {
    @assert S == Abort
    @assert abortReason == 5 and not oxidizerValve and not fuelValve and not igniter
    @stop
}
