[all_states]
at 0 {
    fire = true
    oxPressure = 40
    fuelPressure = 40
}
at 1540 ms: chamberPressure = 3
at 1560 ms: abortButton = true
at 1570 ms: abortButton = false
at 4 s: @stop
