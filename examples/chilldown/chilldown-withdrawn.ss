# The operator withdraws the order: in a pause, in a pulse, while oxygen flows. The valve shuts in that step. The next
# order begins from the start, with all pulses allowed.

[all_states]
at 0: lineTemp = 290
T >= 500 and not chill: chill = true
true: linePressure = 2
true: @assert not lineReady and S != Abort

[Soak]
G < 10000 and T == 1000: chill = false
G < 10000: @assert T <= 1000
G > 40000: lineTemp = 170

[Pulse]
10000 < G < 40000 and T == 100 {
    chill = false
    @assert not chillValve
}
G < 40000: @assert T <= 100

[Flow]
T == 2000 {
    chill = false
    @assert not chillValve
}
true: @assert T <= 2000

[Warm]
true: @assert not chillValve and bleedValve and pulses == 0

[all_states]
at 60 s: @stop
