[all_states]
at 0 {
    goCmd = true
    batteryV = 28
    rangeGreen = true
}
at 6800 ms: holdCmd = true
at 7 s {
    holdCmd = false
    goCmd = false
}
at 20 s: @stop
