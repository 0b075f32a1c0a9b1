# The airbrakes during a coast, the mission played by the script: it allows braking from 0.5 s to 14 s.

[define]
coming = altitude + velocity * velocity / 19.62     # m; the highest point without brakes

[all_states]
at 0: brakeOrder = 0.5                   # at power-on an element may hold anything
at 500 ms: mayBrake = true
at 14 s: mayBrake = false
true: velocity = 280 - 20 * G / 1000
true: altitude = 300 + 270 * G / 1000 - 9.9 * G * G / 1000000
# The drive follows its order, at full speed in half a second.
true: brakePosition = brakePosition + clamp(brakeOrder - brakePosition, -0.02, 0.02)
true: @assert 0 <= brakeOrder <= 1 and S != Jammed

# 240 m/s are left behind after two seconds.
[Retracted]
true: @assert brakeOrder == 0

[Braking]
T == 0: @assert 2 s < G < 2.1 s
T < 800 ms: @assert brakeOrder == 1                       # far too high it would fly: all the way out
mayBrake: @assert brakeOrder == 0 or coming > 2200
mayBrake and coming > 2250: @assert brakeOrder >= 0.25
mayBrake and 2200 < coming < 2300: @assert brakeOrder < 0.5
true: @assert G <= 14.01 s

[all_states]
at 1.9 s: @assert S == Retracted
at 5 s: @assert S == Braking
at 14.1 s: @assert S == Retracted
at 14.1 s: @stop
