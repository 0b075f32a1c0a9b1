[all_states]
at 0 {
    run = true
    inletP = 10
    closedLimit = true
}
at 40 ms: stopBtn = true    # stopped before it was open
at 5 s: @stop
