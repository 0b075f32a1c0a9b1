# The tank is empty: warm gas flows, the line stays warm. After four hundred pulses it gives up, with the vent open.

[options]
delta_t 50

[all_states]
G == 0 {
    lineTemp     = 290
    linePressure = 1
    chillCommand = true
}
true: @assert not lineReady and pulses <= 400

[Abort]
true: @assert pulses == 400 and ventValve and not chillValve
T == 1000: chillCommand = false
T >= 1000: linePressure = 1

[Idle]
G > 10000: @assert not ventValve and not chillValve
G > 10000: @stop
