[all_states]
at 0 {
    begin = true
    posX = 0
}
at 2640 ms: abortTest = true
at 5 s: @stop
