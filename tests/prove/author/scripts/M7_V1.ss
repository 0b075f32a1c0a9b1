[all_states]
at 0 {
    goCmd = true
    batteryV = 28
    rangeGreen = true
}
at 6200 ms: holdCmd = true
at 6700 ms: holdCmd = false
at 12 s: @stop
