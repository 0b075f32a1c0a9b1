# The line cools by 1.5 K in each pulse and warms slowly by itself; the boiling liquid raises the pressure.

[options]
delta_t 50

[all_states]
G == 0 {
    lineTemp     = 290
    linePressure = 1
}
G == 1000: chillCommand = true
chillValve {
    lineTemp     = max(91, lineTemp - 0.25)
    linePressure = linePressure + 0.2
}
not chillValve {
    lineTemp     = lineTemp + 0.002
    linePressure = max(1, linePressure - 0.15)
}
ventValve: linePressure = max(1, linePressure - 1)

true: @assert not (chillValve and linePressure > 14)
true: @assert lineReady == (S == 4)
true: @assert linePressure < 18

[Pulse]
true: @assert T <= 300 and not lineReady

[Ready]
T == 0: @assert lineTemp < 95 and 100 < pulses < 300
T == 10000: @stop
