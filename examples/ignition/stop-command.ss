# Stop by command, in the middle of the burn, and a start that is refused for want of pressure.

[options]
delta_t 5

[all_states]
G == 0: startCommand = true
G == 50: @assert S == 1 and fault == 1 and not purgeValve
G == 100 {
    oxygenInlet    = 30
    fuelInlet      = 30
    igniterCurrent = 1.2
    chamberPressure = 18
}
G == 5000 {
    stopCommand  = true
    startCommand = false
    @assert oxygenValve               # the valve closes at the first step of Shutdown
}
G == 5005: @assert not oxygenValve and fault == 0
G == 8000 {
    @assert S == 1
    @stop
}
