# The velocity reads 0 from the eighth second on, at more than 100 m/s. The parachutes wait until the altitude falls.

[options]
delta_t 10

[all_states]
2000 <= G < 6000 {
    acceleration = 50
    velocity     = 40 * (G / 1000 - 2)
    altitude     = 20 * (G / 1000 - 2) * (G / 1000 - 2)
}
6000 <= G {
    acceleration = -5
    velocity     = 160 - 10.6 * (G / 1000 - 6)
    altitude     = max(40, 320 + 160 * (G / 1000 - 6) - 5.3 * (G / 1000 - 6) * (G / 1000 - 6))
}
G >= 8000: velocity = 0
G == 8000: @assert S == Coast
G < 21000: @assert not deployParachutes
G == 21500 {
    @assert deployParachutes
    @stop
}
