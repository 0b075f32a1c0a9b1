[all_states]
at 0 {
    begin = true
    posX = 0.4
}
at 160 ms: current = 25
at 220 ms: current = 0
at 1 s: @stop
