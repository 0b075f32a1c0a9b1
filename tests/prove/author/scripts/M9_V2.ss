[all_states]
at 0 {
    start = true
    torchP = 4
    torchTemp = 700
}
at 100 ms: abortCmd = true
at 150 ms: abortCmd = false
at 5 s: @stop
