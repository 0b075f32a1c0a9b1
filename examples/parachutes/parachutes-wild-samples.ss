# Single samples are nonsense: on the pad, while climbing, while falling. Nothing may happen because of them.

[options]
delta_t 10

[Pad]
true: altitude = 0
G == 500: altitude = 9999                # as high as an aircraft, for a hundredth of a second
G == 800: altitude = 9999
G > 1000: altitude = 1000 - 5.1 * (G / 1000 - 15) * (G / 1000 - 15)

[Ascent]
true: altitude = 1000 - 5.1 * (G / 1000 - 15) * (G / 1000 - 15)
G == 8000: altitude = 9999               # believed, this would be the highest point, and the next sample a fall
G == 9000: altitude = 40                 # believed, this would be a fall
G == 9010: altitude = 40

[Drogue]
true: altitude = 1000 - (G - 15000) * 0.02
G == 25000: altitude = 9999
G == 26000: altitude = 0
G == 50000: altitude = 0                 # near 300 m: believed, it would open the main

[Main]
T == 0: @assert 235 < roll_avg(altitude, 25) < 255

# These stand here and not in the section of a state: a machine that has left the state would not meet them there.
[all_states]
G < 1000: @assert S == Pad
2000 < G < 15000: @assert S == Ascent and not drogueCharge
17000 < G < 52000: @assert S == Drogue and not mainCharge
G == 56000 {
    @assert S == Main
    @stop
}
