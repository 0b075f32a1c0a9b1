# Abort by command while the pressure builds up: the engine is made safe in the very next step.

[options]
delta_t 10

[all_states]
G == 0: umbilical = true
G == 500: launchCommand = true

[Ignition]
true: chamberPressure = T / 100
T == 600: abortCommand = true
true: @assert T <= 600

[Abort]
T == 0: @assert engineMode == 2
T == 1000: @stop
