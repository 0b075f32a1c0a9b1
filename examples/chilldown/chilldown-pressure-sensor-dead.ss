# The pressure sensor dies in a pulse and reads 0. Nothing flows any more, and Abort does not end: 0 is not "no pressure".

[options]
delta_t 50

[all_states]
G == 0 {
    chill        = true
    lineTemp     = 290
    linePressure = 2
}
G == 10000: chill = false

[Pulse]
T == 100: linePressure = 0
T >= 100: @assert not chillValve

[Abort]
true: @assert G < 5000 or G >= 5000 and not chillValve and bleedValve and not sensorFailed

[all_states]
G == 5000: @assert S == Abort
G == 20000: @assert S == Abort
G == 20000: linePressure = 1
G == 20100 {
    @assert S == Warm
    @stop
}
