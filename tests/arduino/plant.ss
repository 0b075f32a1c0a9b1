# A tank whose vent valve sticks after two seconds.

[options]
delta_t    10
init_state TankVentControl

[all_states]
G == 0: tankPressure = 600
0 < G <= 2000 and valveOpen:  tankPressure = tankPressure - 7
0 < G <= 2000 and !valveOpen: tankPressure = tankPressure + 7
G > 2000: tankPressure = tankPressure + 2
G == 3000: @stop
