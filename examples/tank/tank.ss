# The pressure climbs by 1 psi a step while the valve is shut and falls by 1 while it is open. After half a second
# the vent is blocked.

[options]
delta_t    10
init_state TankVentControl

[all_states]
at 0: tankPressure = 770
valveOpen and G < 500: tankPressure = tankPressure - 1
else:                  tankPressure = tankPressure + 1
tankPressure < 825: @assert S == TankVentControl and valveOpen == (tankPressure > 775)
tankPressure > 825: @assert S == Abort and valveOpen
at 1.1 s: @stop
