# The wire of the thermometer breaks while oxygen flows: it reads 0 K, which is colder than cold enough. Before that, single
# samples of 0 and of 9999 have no effect.

[options]
delta_t 50

[all_states]
G == 0: chill = true
true: linePressure = 2

[Soak]
true: lineTemp = 170

[Flow]
true: lineTemp = 150
T == 1000: lineTemp = 0
T == 1500: lineTemp = 9999
T == 2000: lineTemp = 9999
T >= 4000: lineTemp = 0
T < 4000: @assert S == 4 and chillValve
true: @assert T <= 4100

[all_states]
true: @assert S != 5 and not lineReady

[Abort]
T == 60000: chill = false
T < 60000: @assert sensorFailed and not chillValve and bleedValve
true: @assert T <= 60000

[Warm]
G > 60000: @assert not sensorFailed and not chillValve and bleedValve
T == 1000: @stop
