# The velocity reads 0 from the eighth second on, at more than 100 m/s. The parachutes wait until the altitude falls.

[all_states]
from 2 s to 6 s {
    acceleration = 50
    velocity     = 40 * (G / 1000 - 2)
    altitude     = 20 * (G / 1000 - 2) * (G / 1000 - 2)
}
after 6 s {
    acceleration = -5
    velocity     = 160 - 10.6 * (G / 1000 - 6)
    altitude     = max(40, 320 + 160 * (G / 1000 - 6) - 5.3 * (G / 1000 - 6) * (G / 1000 - 6))
}
after 8 s: velocity = 0
at 8 s: @assert S == Coast
G < 21000: @assert not deployParachutes
at 21.5 s: @assert deployParachutes
at 21.5 s: @stop
