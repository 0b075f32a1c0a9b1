# The altimeter freezes on the way up: the timers open both parachutes, one after the other.

[all_states]
G == 0: armed = true
G <= 2 s: altitude = 0
G > 2 s: altitude = 700
true: @assert not (drogueFire and mainFire)

[drogue.Firing]
drogue.T == 0: @assert 32 s < G < 32.5 s

[main.Firing]
main.T == 0: @assert 92 s < G < 92.5 s and drogue.S == Fired

[main.Fired]
main.T == 0: @stop
