# The igniter does not light: no propellant may flow.

[all_states]
at 1 s: fire = true
true: @assert not oxidizerValve and not fuelValve
at 10 s: fire = false
at 9.99 s: @assert S == Abort              # as long as the key is held

[Ignite]
T < 2 s: @assert igniter and abortReason == 0

[Abort]
true: @assert abortReason == 2 and not igniter and purgeValve

[Idle]
G > 10 s: @assert not purgeValve and abortReason == 2
at 10.02 s: @stop
