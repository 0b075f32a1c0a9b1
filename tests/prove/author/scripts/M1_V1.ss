[all_states]
at 0 {
    fire = true
    oxPressure = 40
    fuelPressure = 40
}
at 3030 ms: chamberPressure = 3   # the last step of Ignite
at 4 s: @stop
