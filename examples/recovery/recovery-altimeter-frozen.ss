# The altimeter freezes on the way up: the drogue opens by the timer, and so does the main.

[options]
delta_t 10

[Pad]
G > 1000: altitude = 150

[Drogue]
T == 0: @assert 13000 < G < 13300
T >= 1000: @assert not drogueCharge

[Main]
T == 0: @assert 22000 < G < 22200
T < 1000: @assert mainCharge
T >= 1000 {
    @assert not mainCharge
    @stop
}
