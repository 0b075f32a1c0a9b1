# The altimeter freezes on the way up: the drogue opens by the timer, and so does the main.

[Pad]
G > 1 s: altitude = 150

[Drogue]
T == 0: @assert 13 s < G < 13.3 s
T >= 1 s: @assert not drogueCharge

[Main]
T == 0: @assert 22 s < G < 22.2 s
T < 1 s: @assert mainCharge
T >= 1 s: @assert not mainCharge
T >= 1 s: @stop
