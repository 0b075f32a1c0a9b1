# The accelerometer delivers nothing, but the rocket rises: the flight goes on.

[options]
delta_t 10

[all_states]
at 0: tankPressure = 40
from 3 s to 6 s {
    velocity = 50
    altitude = altitude + 0.5
}
true: @assert S != Scrub
at 5 s: @assert S == Powered
at 8 s: @assert S == Coast
at 8 s: @stop
