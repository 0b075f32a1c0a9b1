[all_states]
at 0 {
    enable = true
    bottleP = 200
    tankP = 0
}
at 100 ms: tankP = 25
at 300 ms: tankP = 20
at 400 ms: enable = false
at 410 ms: enable = true
at 2 s: @stop
