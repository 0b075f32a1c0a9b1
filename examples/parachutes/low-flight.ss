# A weak motor: the top is at 100 m already, below where the main opens. First the drogue, a second later the main.

[options]
delta_t 20

[all_states]
G == 0: armed = true
1000 <= G < 2000: acceleration = 40
G >= 2000: acceleration = -1
1000 <= G < 10000: altitude = 100 - 4.9 * (G / 1000 - 5.5) * (G / 1000 - 5.5)
true: @assert not (drogueCharge and mainCharge)

[Drogue]
T == 0: @assert drogueCharge
true: @assert T <= 1020

[Main]
T == 0: @assert mainCharge and altitude > 50
T == 0: @stop
