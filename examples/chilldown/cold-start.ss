# A start with a warm line, which the other scripts include.

[options]
delta_t 50

[all_states]
at 0 {
    chill        = true
    lineTemp     = 290
    linePressure = 1
}
