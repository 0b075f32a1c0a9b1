# Single samples are nonsense: on the pad, while climbing, while falling. Nothing may happen because of them.

[define]
t      = G / 1000 - 15
flight = 1000 - 5.1 * t * t

[Pad]
true: altitude = 0
at 500 ms: altitude = 9999                # as high as an aircraft, for a hundredth of a second
at 800 ms: altitude = 9999
G > 1 s: altitude = flight

[Ascent]
true: altitude = flight
at 8 s: altitude = 9999               # believed, this would be the highest point, and the next sample a fall
at 9 s: altitude = 40                 # believed, this would be a fall
at 9.01 s: altitude = 40

[Drogue]
true: altitude = 1000 - (G - 15000) * 0.02
at 25 s: altitude = 9999
at 26 s: altitude = 0
at 50 s: altitude = 0                 # near 300 m: believed, it would open the main

[Main]
T == 0: @assert 235 < roll_avg(altitude, 25) < 255

# These stand here and not in the section of a state: a machine that has left the state would not meet them there.
[all_states]
G < 1 s: @assert S == Pad
2 s < G < 15 s: @assert S == Ascent and not drogueCharge
17 s < G < 52 s: @assert S == Drogue and not mainCharge
at 56 s: @assert S == Main
at 56 s: @stop
