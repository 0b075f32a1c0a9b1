# A good start, eight seconds of burn, an orderly stop.

[options]
delta_t 5

[all_states]
G == 0 {
    oxygenInlet = 30
    fuelInlet   = 30
}
G == 100: startCommand = true
G == 9000: startCommand = false
# The hardware: the igniter draws 1.2 A; with both valves open the pressure rises to 18 bar in 0.3 s.
igniter: igniterCurrent = 1.2
not igniter: igniterCurrent = 0
fuelValve and oxygenValve: chamberPressure = min(18, chamberPressure + 0.3)
not (fuelValve and oxygenValve): chamberPressure = max(0, chamberPressure - 0.5)

# At all times: no oxygen without fuel, no nitrogen into an open engine.
true: @assert not (oxygenValve and not fuelValve)
true: @assert not (purgeValve and (fuelValve or oxygenValve))
true: @assert fault == 0
# The order of events.
2200 < G < 2600: @assert igniter and not fuelValve
2610 < G < 2740: @assert fuelValve and not oxygenValve
2800 < G < 10900: @assert fuelValve and oxygenValve
3150 < G: @assert not igniter
G == 11400: @assert purgeValve and S == 7
G == 14000 {
    @assert S == 1 and not purgeValve
    @stop
}
