[all_states]
at 0 {
    goCmd = true
    batteryV = 28
    rangeGreen = true
}
at 200 ms: wind = 13
at 500 ms: wind = 12
at 5 s: @stop
