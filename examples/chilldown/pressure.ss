# A blocked vent: the pressure climbs while liquid boils. First no more liquid is let in, then everything is opened.

[options]
delta_t 50

[all_states]
G == 0 {
    lineTemp     = 200
    linePressure = 1
    chillCommand = true
}
G > 2000: linePressure = linePressure + 0.1
linePressure > 12.2: @assert not chillValve
12.2 < linePressure <= 18: @assert ventValve

[Abort]
true: @assert linePressure > 18 and ventValve and not chillValve
T == 2000: @stop
