# The igniter fails: the pressure stays low, and after two seconds the mission gives up. When the ground has taken back its
# command, the rocket is ready again.

[options]
delta_t 10

[all_states]
G == 0: umbilical = true
G == 500: launchCommand = true
G == 4000: launchCommand = false

[Ignition]
true: chamberPressure = 2
true: @assert T <= 2010

[Abort]
true: chamberPressure = max(0, chamberPressure - 0.05)
true: @assert engineMode == 2 and recoveryMode == 0

[Ready]
G > 4000: @assert G >= 4010 and chamberPressure < 1
G > 6000: @stop
