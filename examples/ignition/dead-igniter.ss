# The igniter draws no current: no valve ever opens.

[options]
delta_t 5

[all_states]
G == 0 {
    oxygenInlet = 30
    fuelInlet   = 30
}
G == 100: startCommand = true
true: @assert not fuelValve and not oxygenValve

[Shutdown]
true: @assert fault == 2
T == 1000: @stop
