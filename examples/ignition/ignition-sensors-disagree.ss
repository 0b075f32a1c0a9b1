# Two sensors fail, and no two of the three agree any more.

include "burning.ss"

# First each of the sensors alone is wrong for 300 ms, with one sample of another one wrong too: no reason to stop. From 2 s on
# two are wrong, each in its own way.
[Burn]
1 s <= T < 1.3 s: pressureA = 27
1.3 s <= T < 1.6 s: pressureB = 27
1.6 s <= T < 1.9 s: pressureC = 27
T == 1.2 s: pressureC = 13
T == 1.5 s: pressureA = 13
T == 1.8 s: pressureB = 13
T >= 2 s {
    pressureB = 27
    pressureC = 13
}
true: @assert T <= 2.09 s

[all_states]
2.7 s < G < 4.6 s: @assert S == Burn and fuelValve

[Abort]
true: @assert abortReason == 6 and not oxidizerValve and not fuelValve and purgeValve
T == 100 ms: @stop
