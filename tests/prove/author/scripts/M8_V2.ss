[all_states]
at 0 {
    run = true
    inletP = 10
    closedLimit = true
}
at 5 s: @stop
