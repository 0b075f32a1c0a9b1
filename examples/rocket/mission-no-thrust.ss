# The valve is opened and nothing happens: a second later it is shut again, and the charge is not fired beside people.

[options]
delta_t 10

[all_states]
at 0 {
    tankPressure = 40
    acceleration = 9.8
}
true: @assert parachuteMode == 1
at 4 s: @assert engineMode == 2
at 4.05 s {
    @assert S == Scrub
    @assert engineMode == 1 and not flying
}
at 20 s: @assert S == Scrub
at 20 s: @stop
