# The pressure rises above what is allowed, in the middle of the burn.

include "burning.ss"

[Burn]
T >= 1.5 s {
    pressureA = 30
    pressureB = 31
    pressureC = 29
}
true: @assert T <= 1.51 s

[all_states]
2.7 s < G < 4.1 s: @assert S == Burn and fuelValve

[Abort]
true: @assert abortReason == 5 and not oxidizerValve and not fuelValve and purgeValve
T == 100 ms: @stop
