# The chamber is under pressure before anything has been opened. The key may be turned: nothing starts.

[all_states]
true {
    pressureB = 3
    pressureC = 3
}
at 1 s: fire = true
true: @assert S == Idle and not igniter and not oxidizerValve and not fuelValve and not purgeValve
at 10 s: @stop
