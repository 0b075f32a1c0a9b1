# A bad contact: the current drops out every 50 ms. That is no igniter to rely on.

[options]
delta_t 5

[all_states]
G == 0 {
    oxygenInlet = 30
    fuelInlet   = 30
}
G == 100: startCommand = true
true: igniterCurrent = 1.2 * (G / 50 != floor(G / 50))
true: @assert not fuelValve and not oxygenValve

[Shutdown]
true: @assert fault == 2
T == 100: @stop
