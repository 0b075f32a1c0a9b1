# A chill-down as it should be, by a simple picture of the line: each pulse costs it about 6 K and raises the pressure,
# steady flow cools it by 8 K a second down to 91 K, and with the valve shut it warms up slowly.

[all_states]
at 0: lineTemp = 290
at 0: linePressure = 1
at 0: chillValve = true                # at power-on an element may hold anything
at 0: lineReady = true
at 1 s: chill = true
at 500 s: chill = false
chillValve {
    lineTemp = max(91, lineTemp - 0.4)
    linePressure = min(6, linePressure + 0.8)
}
else {
    lineTemp = lineTemp + 0.005
    linePressure = max(1, linePressure - 0.2)
}
true: @assert bleedValve and not sensorFailed and (S == Ready or not lineReady)

[Warm]
true: @assert not chillValve and not lineReady

# Never longer than 200 ms into a warm line, never into a line with more than 4 bar, and two seconds between pulses.
[Pulse]
chillValve: lineTemp = lineTemp - 1
T == 0: @assert linePressure < 5 and lineTemp >= 179
true: @assert T <= 200
T < 200: @assert chillValve
T == 200: @assert not chillValve

[Soak]
true: @assert not chillValve
true: @assert T <= 2000

[Flow]
T == 0: @assert lineTemp < 180
T < 5000: @assert chillValve and not lineReady

# Ready only when the line has been below 95 K for five seconds; and then it is kept so.
[Ready]
T == 0: @assert roll_max(lineTemp, 100) < 95
T > 0 and chill: @assert lineReady and 90 < lineTemp < 98.5
T > 1000 and lineTemp < 94: @assert not chillValve

[all_states]
at 900 ms: @assert S == Warm
at 40 s: @assert S == Pulse or S == Soak
at 400 s: @assert S == Ready
at 500.1 s: @assert S == Warm and not chillValve and not lineReady
at 500.1 s: @stop
