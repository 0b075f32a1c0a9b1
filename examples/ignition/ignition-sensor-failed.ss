# One of three pressure sensors fails, each in its own way and at a bad moment: the burn goes on as if nothing had been.

[all_states]
at 0: pressureA = 50
at 1 s: fire = true
true: @assert abortReason == 0

[Ignite]
T == 100 ms: igniterLit = true

# Sensor A says from the start that the chamber is full of pressure. Believed, it would end the ignition at once.
[Start]
true {
    pressureA = 50
    pressureB = max(0, T - 100) / 5
    pressureC = max(0, T - 100) / 5
}
T == 90 ms {                               # for one single step the other two see a spike too
    pressureB = 35
    pressureC = 35
}

# It stays so for half a second; then it works, and sensor C falls to zero, which would be a flame-out; then A does.
[Burn]
true {
    pressureA = 50
    pressureB = min(20, 8 + T / 20)
    pressureC = min(20, 8 + T / 20)
}
T >= 500 ms {
    pressureA = 20
    pressureC = 0
}
T >= 2.5 s {
    pressureA = 0
    pressureC = 20
}
# For one single step all of them see a spike.
T == 2 s {
    pressureA = 35
    pressureB = 35
    pressureC = 35
}
T < 4 s: @assert oxidizerValve and fuelValve

[all_states]
2.7 s < G < 6.5 s: @assert S == Burn

[Shutdown]
T == 200 ms: @assert not oxidizerValve and not fuelValve
T == 200 ms: @stop
