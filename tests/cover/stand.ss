[all_states]
G == 0:      p = 20
G == 50:     @assert valve and S == Idle
G == 60:     p = 55
G == 100:    @assert not valve
G == 120:    @assert S == Fill and valve
G == 130:    @assert code == 0
G == 200:    p = 70
G == 240:    @assert S == Fill
G == 260:    @assert S == Done and not valve
G == 300:    p = 120
G == 320:    @assert S == Abort and valve
G == 330:    @stop
