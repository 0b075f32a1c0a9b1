# The flight as it should be: ignition after 3 s, the tank is empty at 6 s, the highest point is reached at 14 s.

[options]
delta_t 10

[all_states]
at 0 {
    tankPressure = 40
    acceleration = 9.8
}
from 3 s to 6 s {
    tankPressure = 40 - 19.5 * (G - 3000) / 3000
    acceleration = 36
    velocity     = 80 * (G - 3000) / 3000
    altitude     = altitude + velocity / 100
}
after 6 s: tankPressure = 20
from 6 s to 14 s {
    acceleration = 0
    velocity     = 80 - (G - 6000) / 100
    altitude     = altitude + velocity / 100
}
after 14 s {
    acceleration = 9.8
    velocity     = -10
    altitude     = max(0, altitude - 0.1)
}
from 10 s to 10.03 s: velocity = -300    # the navigation jumps, for three steps
true {
    @assert engineMode == 1 or S == Powered
    @assert parachuteMode == 1 or S == Recovery
    @assert engineMode > 0 and parachuteMode > 0
}

[Countdown]
true: @assert engineMode == 1 and parachuteMode == 1 and not flying and G <= 3000

[Powered]
T == 0: @assert engineMode == 2 and flying and G == 3010

[Coast]
true: @assert engineMode == 1 and parachuteMode == 1
T == 0: @assert 5900 < G < 6100

[Recovery]
T == 0: @assert parachuteMode == 2 and 14000 < G < 14100

[Landed]
true: @assert altitude == 0 and parachuteMode == 1 and engineMode == 1

[all_states]
at 5 s: @assert S == Powered
at 10.5 s: @assert S == Coast
at 20 s: @assert S == Recovery
at 80 s: @assert S == Landed
at 80 s: @stop
