# Igniter and valves do as they are told, but nothing burns: everything is closed after 0.3 s of oxygen.

[options]
delta_t 5

[all_states]
G == 0 {
    oxygenInlet    = 30
    fuelInlet      = 30
    igniterCurrent = 1.2
}
G == 100: startCommand = true
oxygenValve: chamberPressure = 1.5         # cold gas

[Rise]
true: @assert T <= 300

[Shutdown]
T == 0: @assert fault == 3 and not oxygenValve and fuelValve
T >= 105: @assert not fuelValve
T >= 205: @assert purgeValve
# With the start command still given it does not begin again by itself.
T == 5000: @stop
