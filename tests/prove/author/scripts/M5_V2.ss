[all_states]
at 0 {
    go = true
    pumpTemp = 80
    lineTemp = 90
}
at 500 ms: pumpTemp = 300
at 2 s: @stop
