# Fuel has gathered before it catches fire: the pressure jumps to 27 bar. The oxygen is shut within 15 ms.

[options]
delta_t 5

[all_states]
G == 0 {
    oxygenInlet    = 30
    fuelInlet      = 30
    igniterCurrent = 1.2
}
G == 100: startCommand = true

[Rise]
T >= 200: chamberPressure = 27
true: @assert T <= 205

[Shutdown]
T == 0: @assert fault == 4 and not oxygenValve
T == 500: @stop
