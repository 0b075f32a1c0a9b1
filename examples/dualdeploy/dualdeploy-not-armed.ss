# The pin has not been pulled: no igniter gets current, whatever the altimeter says.

[all_states]
G <= 2 s: altitude = 0
2 s < G < 10 s: altitude = 1000
G >= 10 s: altitude = 0
true: @assert not drogueFire and not mainFire
true: @assert drogue.S == Waiting and main.S == Waiting

[flight.Main]
flight.T == 5 s: @stop
