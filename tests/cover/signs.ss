[options]
delta_t 10

[all_states]
G == 0:  tilt = -5
G == 10: rate = 20
G == 20: @assert wheel == -15 and trim == 10 and rest == -1
G == 30: rate = -70
G == 60: rate = -80
G == 80: @assert state Fast
G == 90: rate = -101
G == 120 {
    @assert state Hold and trim < 0
    @stop
}
