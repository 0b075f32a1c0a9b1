[all_states]
at 0 {
    begin = true
    posX = 0
}
at 720 ms: abortTest = true
at 5 s: @stop
