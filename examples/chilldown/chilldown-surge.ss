# Too much pressure, once in each state in which there may be some. Every time the valve is shut in the same step, and nothing
# goes on before the pressure has left and the operator has withdrawn the order.

[all_states]
at 0: lineTemp = 290
not chill and T >= 500: chill = true
true: linePressure = 2
linePressure <= 12: @assert not sensorFailed and bleedValve

# First during the first pause, then during the first pulse, then while oxygen flows, at last with the line ready.
[Soak]
G < 20000 {
    lineTemp     = 290
    linePressure = 13
}
G > 20000: lineTemp = 290
G > 60000: lineTemp = 170
G < 20000: @assert T == 0

[Pulse]
G > 20000: linePressure = 13
true: @assert T == 0 and not chillValve and G < 60000

[Flow]
true: lineTemp = 92
60000 < G < 100000 and T >= 3000: linePressure = 13
G < 100000: @assert T <= 3000
T < 3000: @assert chillValve
G < 100000 and T == 3000: @assert not chillValve
true: @assert T <= 5050

[Ready]
T >= 4000: linePressure = 13
T < 4000: @assert lineReady
true: @assert T <= 4000 and G > 100000
T == 4000: @assert not lineReady

# Order withdrawn after ten seconds, pressure gone after fifteen.
[Abort]
T < 15000: linePressure = 5
T == 10000: chill = false
T > 10000: chill = false
true: @assert T <= 15000 and not chillValve and not lineReady and bleedValve

[all_states]
at 10 s: @assert S == Abort
at 30 s: @assert S == Abort
at 140 s: @stop
