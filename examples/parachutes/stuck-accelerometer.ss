# After launch the accelerometer hangs at its last value: the timer ends Boost, and the barometer does the rest.

[options]
delta_t 20

[all_states]
G == 0: armed = true
G >= 1000: acceleration = 70
G >= 1000: altitude = 1000 - (G / 100 - 160) * (G / 100 - 160) / 22.5

[Boost]
true: @assert T <= 6020

[Drogue]
T == 0: @assert drogueCharge and G < 18000     # the top was at 16 s
T > 100: @stop
