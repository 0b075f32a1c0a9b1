# The pressure climbs by 1 psi a step while the valve is shut and falls by 1 while it is open.

[options]
delta_t    10
init_state TankVentControl

[all_states]
at 0 {
    tankPressure = 600
    valveOpen    = false
}
valveOpen:  tankPressure = tankPressure - 1
!valveOpen: tankPressure = tankPressure + 1
at 1 s:  @stop

[TankVentControl]
true: @assert valveOpen == (tankPressure > 775)
