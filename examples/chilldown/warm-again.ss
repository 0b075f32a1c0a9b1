# Ready, and then the launch waits: the line warms up, and is chilled again.

[options]
delta_t 50

[all_states]
G == 0 {
    lineTemp     = 92
    linePressure = 1
    chillCommand = true
}

[Ready]
true: lineTemp = lineTemp + 0.05
lineTemp < 110: @assert lineReady
true: @assert lineTemp < 111

[Pulse]
T == 0 and G > 5000: @assert not lineReady and lineTemp > 110
G > 5000: @stop
