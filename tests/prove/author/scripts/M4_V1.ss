[all_states]
at 0 {
    enable = true
    bottleP = 200
    tankP = 25
}
at 1 s: @stop
