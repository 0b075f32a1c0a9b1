# The airbrakes during a coast, the mission played by the script: it allows braking from 0.5 s to 14 s.

[options]
delta_t 10

[all_states]
G == 0: brakeOrder = 0.5                   # at power-on an element may hold anything
G == 500: mayBrake = true
G == 14000: mayBrake = false
true: velocity = 280 - 20 * G / 1000
true: altitude = 300 + 270 * G / 1000 - 9.9 * G * G / 1000000
# The drive follows its order, at full speed in half a second.
true: brakePosition = brakePosition + clamp(brakeOrder - brakePosition, -0.02, 0.02)
true: @assert 0 <= brakeOrder <= 1 and S != Jammed

# 240 m/s are left behind after two seconds.
[Retracted]
true: @assert brakeOrder == 0

[Braking]
T == 0: @assert 2000 < G < 2100
T < 800: @assert brakeOrder == 1                       # far too high it would fly: all the way out
mayBrake: @assert brakeOrder == 0 or altitude + velocity * velocity / 19.62 > 2200
mayBrake and 2250 < altitude + velocity * velocity / 19.62: @assert brakeOrder >= 0.25
mayBrake and 2200 < altitude + velocity * velocity / 19.62 < 2300: @assert brakeOrder < 0.5
true: @assert G <= 14010

[all_states]
G == 1900: @assert S == Retracted
G == 5000: @assert S == Braking
G == 14100 {
    @assert S == Retracted
    @stop
}
