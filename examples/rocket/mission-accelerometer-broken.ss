# The accelerometer delivers nothing, but the rocket rises: the flight goes on.

[options]
delta_t 10

[all_states]
G == 0: tankPressure = 40
3000 <= G < 6000 {
    velocity = 50
    altitude = altitude + 0.5
}
true: @assert S != Scrub
G == 5000: @assert S == Powered
G == 8000 {
    @assert S == Coast
    @stop
}
