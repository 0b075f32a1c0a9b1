# The chamber is under pressure before anything has been opened. The key may be turned: nothing starts.

[options]
delta_t 10

[all_states]
true {
    pressureB = 3
    pressureC = 3
}
G == 1000: fire = true
true: @assert S == Idle and not igniter and not oxidizerValve and not fuelValve and not purgeValve
G == 10000: @stop
