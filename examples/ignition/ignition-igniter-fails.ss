# The igniter does not light: no propellant may flow.

[options]
delta_t 10

[all_states]
G == 1000: fire = true
true: @assert not oxidizerValve and not fuelValve
G == 10000: fire = false

[Ignite]
T < 2000: @assert igniter and abortReason == 0

[Abort]
true: @assert abortReason == 2 and not igniter and purgeValve
G == 9990: @assert S == Abort              # as long as the key is held

[Idle]
G > 10000: @assert not purgeValve and abortReason == 2
G == 10020: @stop
