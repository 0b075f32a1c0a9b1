[all_states]
at 0 {
    startFill = true
    loxTemp = 90
    loxLevel = 40
    loxPressure = 3
}
at 2200 ms: holdFill = true
at 2300 ms: holdFill = false
at 5 s: @stop
