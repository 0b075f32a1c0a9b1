# Ice blocks the bleed valve: the pressure of the first pulse does not leave. No second pulse, and after 20 s the end.

include "cold-start.ss"

[Pulse]
true: linePressure = 6
true: @assert pulses == 1

[Soak]
true: @assert T <= 20050 and not chillValve

[Abort]
true: @assert pulses == 1 and not sensorFailed and not chillValve
T == 100: @stop
