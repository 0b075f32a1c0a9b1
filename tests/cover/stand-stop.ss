[all_states]
G == 0:      p = 110
G == 10:     p = 0
G == 20:     p = 110
G == 30:     @assert code == 2
G == 100:    stop = true
G == 110 {
    @assert S == Abort and code == 1
    @stop
}
