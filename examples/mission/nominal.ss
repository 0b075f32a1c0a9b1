# A whole flight: ignition, eighteen seconds of thrust, top at 11 km, landing.

[options]
delta_t 10

[all_states]
G == 0 {
    umbilical    = true
    acceleration = 9.8
}
G == 1000: launchCommand = true

[Ready]
true: @assert engineMode == 2 and recoveryMode == 0
true: @assert G <= 1000

[Ignition]
chamberPressure < 20: chamberPressure = chamberPressure + 0.2
chamberPressure > 15: umbilical = false
true: @assert engineMode == 1 and telemetryRate == 100
true: @assert T <= 800

[PoweredFlight]
true: altitude = 10 * (T / 1000) * (T / 1000)
true: @assert not umbilical
T < 18000: @assert engineMode == 1
true: @assert T <= 18010

[Coast]
true: chamberPressure = max(0, chamberPressure - 0.5)
true: altitude = 3240 + 360 * (T / 1000) - 4.9 * (T / 1000) * (T / 1000)
true: @assert engineMode == 2 and recoveryMode == 1
true: @assert T < 39000            # the top is 36.7 s after the end of thrust

[Descent]
altitude > 0: altitude = max(0, altitude - 0.3)
true: @assert engineMode == 2 and recoveryMode == 1 and telemetryRate == 20
true: @assert 9852.2 < apogee < 9852.3

[Landed]
true: @assert altitude == 0 and engineMode == 0 and telemetryRate == 1
true: @stop
