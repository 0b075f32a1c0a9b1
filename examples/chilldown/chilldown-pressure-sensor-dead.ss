# The pressure sensor dies in a pulse and reads 0. Nothing flows any more, and Abort does not end: 0 is not "no pressure".

include "cold-start.ss"

[all_states]
at 0: linePressure = 2
at 10 s: chill = false

[Pulse]
T == 100: linePressure = 0
T >= 100: @assert not chillValve

[Abort]
true: @assert G < 5000 or G >= 5000 and not chillValve and bleedValve and not sensorFailed

[all_states]
at 5 s: @assert S == Abort
at 20 s: @assert S == Abort
at 20 s: linePressure = 1
at 20.1 s: @assert S == Warm
at 20.1 s: @stop
