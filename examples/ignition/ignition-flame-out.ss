# Sensor A wakes up late: the engine must start by the other two. After two seconds the flame goes out: the pressure falls to 5 bar. A dip of 90 ms before that is no flame-out.

[options]
delta_t 10

[all_states]
G == 1000: fire = true

[Ignite]
T == 100: igniterLit = true

[Start]
true {
    pressureA = 0
    pressureB = 10
    pressureC = 10
}

[Burn]
true {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
1000 <= T < 1090 or T >= 2000 {
    pressureA = 5
    pressureB = 5
    pressureC = 5
}
true: @assert T <= 2090

[all_states]
2700 < G < 4600: @assert S == Burn and oxidizerValve and fuelValve

[Abort]
true: @assert abortReason == 4 and not oxidizerValve and not fuelValve and purgeValve
T == 100: @stop
