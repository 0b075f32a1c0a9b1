# The barometer is dead: it says 0 for ever. The drogue comes by the timer, the main right after it.

[options]
delta_t 20

[all_states]
G == 0 {
    armed        = true
    acceleration = 9.8
}
1000 <= G < 4000: acceleration = 70
G >= 4000: acceleration = -1
true: @assert not (drogueCharge and mainCharge)

[Coast]
true: @assert T <= 25020

[Drogue]
T == 0: @assert drogueCharge
T == 1000: @assert not drogueCharge
true: @assert T <= 1020

[Main]
T == 0: @assert mainCharge
T > 1000: @stop
