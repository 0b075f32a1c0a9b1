# The valve is opened and nothing happens: a second later it is shut again, and the charge is not fired beside people.

[options]
delta_t 10

[all_states]
G == 0 {
    tankPressure = 40
    acceleration = 9.8
}
true: @assert parachuteMode == 1
G == 4000: @assert engineMode == 2
G == 4050 {
    @assert S == Scrub
    @assert engineMode == 1 and not flying
}
G == 20000 {
    @assert S == Scrub
    @stop
}
