# A start with a warm line, which the other scripts include.

[all_states]
at 0 {
    chill        = true
    lineTemp     = 290
    linePressure = 1
}
