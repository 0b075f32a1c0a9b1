# The flame goes out after two seconds of burn. A single bad reading before that must not stop the engine.

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
true: chamberPressure = 18

[MainStage]
true: chamberPressure = 18
T == 500: chamberPressure = 0
T == 800: chamberPressure = 60
T >= 2000: chamberPressure = 2
T < 2000: @assert fault == 0
true: @assert T <= 2020

[Shutdown]
T == 0: @assert fault == 5
T == 5: @stop
