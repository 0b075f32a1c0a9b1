[all_states]
at 0 {
    go = true
    pumpTemp = 80
    lineTemp = 100
}
at 100 ms: lineTemp = 300
at 200 ms: lineTemp = 100
at 2 s: @stop
