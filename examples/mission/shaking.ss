# Somebody shakes the rocket: no launch, until it has stood still for half a second.

[options]
delta_t 10

[all_states]
G == 0: umbilical = true
G == 100: launchCommand = true
true: acceleration = 9.8
G <= 3000 and G / 100 == floor(G / 100): acceleration = 40

[Ready]
100 < G <= 3400: @assert S == 1 and engineMode == 2

[Ignition]
true: @assert 3490 <= G <= 3510
true: @stop
