# An engine that lights and burns as it should, which other scripts include and then disturb.

[all_states]
at 1 s: fire = true

[Ignite]
T == 100 ms: igniterLit = true

[Start]
true {
    pressureA = 10
    pressureB = 10
    pressureC = 10
}

[Burn]
true {
    pressureA = 20
    pressureB = 20
    pressureC = 20
}
