# The wire of the thermometer breaks: it reads 0 K, which is colder than cold enough. Once in a pause, once while oxygen flows, once
# with the line ready. Before that, single samples of 0 and of 9999 have no effect.

[all_states]
at 0: lineTemp = 290
not chill and T >= 500: chill = true
true: linePressure = 2

[Soak]
true: lineTemp = 170
G < 20000: lineTemp = 290
T == 500: lineTemp = 0
T == 1000: lineTemp = 9999
G < 20000 and T >= 1500: lineTemp = 0
G < 20000: @assert T <= 1650

[Flow]
true: lineTemp = 92
G < 60000: lineTemp = 96
T == 1000: lineTemp = 0
T == 1500: lineTemp = 80
G < 60000 and T >= 4000: lineTemp = 0
G < 60000: @assert T <= 4150
T < 4000: @assert chillValve and not lineReady

[Ready]
true: lineTemp = 92
T == 500: lineTemp = 0
T == 1000: lineTemp = 9999
T >= 4000: lineTemp = 9999
T < 4000: @assert lineReady and not chillValve or T == 0
true: @assert T <= 4150

# The order is withdrawn after ten seconds.
[Abort]
T >= 10000: chill = false
T == 10000: lineTemp = 290
T < 10000: @assert sensorFailed and not chillValve and bleedValve and not lineReady
true: @assert T <= 10000

[Warm]
G > 1000: @assert not sensorFailed and not chillValve and bleedValve

[all_states]
at 10 s: @assert S == Abort
at 21 s: @assert S == Abort
at 68 s: @assert S == Ready or S == Flow
at 78 s: @stop
