[all_states]
at 0 {
    startFill = true
    loxTemp = 90
    loxLevel = 40
    loxPressure = 3
}
at 2150 ms: loxPressure = 7     # in the first step of FastFill
at 5 s: @stop
