# The engine goes out after five seconds: the flight goes on to recovery by itself, and the engine is safe.

[options]
delta_t 10

[all_states]
G == 0: umbilical = true
G == 500: launchCommand = true

[Ignition]
true: chamberPressure = 20
T > 500: umbilical = false

[PoweredFlight]
T < 5000: chamberPressure = 20
T >= 5000: chamberPressure = 1
true: altitude = 10 * (T / 1000) * (T / 1000)
true: @assert T <= 5100

[Coast]
T == 0: @assert engineMode == 2 and recoveryMode == 1
# A command from the ground changes nothing in flight.
T == 100: abortCommand = true
true: altitude = 260 + 100 * (T / 1000) - 4.9 * (T / 1000) * (T / 1000)
true: @assert T < 12500

[Descent]
T == 100: @assert apogee > 760 and recoveryMode == 1
T == 100: @stop
