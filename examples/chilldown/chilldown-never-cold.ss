# Oxygen flows and flows, and the line stays 1 K too warm, but for moments: after two minutes the end. No sensor is to blame.

[all_states]
at 0: chill = true
true {
    linePressure = 2
    lineTemp     = 96
}
T > 4000 {
    lineTemp = 94
    every 4 s: lineTemp = 97             # never for five seconds on end
}
G < 121000: @assert not lineReady and S != Abort
true: @assert S != Ready

[Flow]
T == 120000: @assert chillValve
true: @assert T <= 120050

[Abort]
true: @assert not chillValve and not sensorFailed
T == 1000: @stop
