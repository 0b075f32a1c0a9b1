[all_states]
at 0 {
    startFill = true
    loxTemp = 90
    loxLevel = 100
    loxPressure = 3
}
at 2 s: @stop
