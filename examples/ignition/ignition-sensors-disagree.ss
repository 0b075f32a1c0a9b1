# Two sensors fail, and no two of the three agree any more.

[options]
delta_t 10

[all_states]
G == 1000: fire = true

[Ignite]
T == 100: igniterLit = true

[Start]
true {
    pressureA = 10
    pressureB = 10
    pressureC = 10
}

# First each of the sensors alone is wrong for 300 ms, with one sample of another one wrong too: no reason to stop. From 2 s on
# two are wrong, each in its own way.
[Burn]
true {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
1000 <= T < 1300: pressureA = 27
1300 <= T < 1600: pressureB = 27
1600 <= T < 1900: pressureC = 27
T == 1200: pressureC = 13
T == 1500: pressureA = 13
T == 1800: pressureB = 13
T >= 2000 {
    pressureB = 27
    pressureC = 13
}
true: @assert T <= 2090

[all_states]
2700 < G < 4600: @assert S == Burn and fuelValve

[Abort]
true: @assert abortReason == 6 and not oxidizerValve and not fuelValve and purgeValve
T == 100: @stop
