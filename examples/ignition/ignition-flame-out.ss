# Sensor A wakes up late: the engine must start by the other two. After two seconds the flame goes out: the pressure falls to 5 bar. A dip of 90 ms before that is no flame-out.

include "burning.ss"

[Start]
true: pressureA = 0

[Burn]
1 s <= T < 1.09 s or T >= 2 s {
    pressureA = 5
    pressureB = 5
    pressureC = 5
}
true: @assert T <= 2.09 s

[all_states]
2.7 s < G < 4.6 s: @assert S == Burn and oxidizerValve and fuelValve

[Abort]
true: @assert abortReason == 4 and not oxidizerValve and not fuelValve and purgeValve
T == 100 ms: @stop
