# Sensors with realistic noise; one after the other breaks and is repaired.

[all_states]
true {
    chamberPressureA = 1 + G / 1000000
    chamberPressureB = 1 + G / 1000000
    tankPressure     = 40 + G / 1000000
    lineTemperature  = 290 + G / 1000000
    flow             = G / 1000000
}
G < 3 s: @assert sensorFault == 0

# Nothing read, for two steps and then for three.
3 s <= G <= 3.01 s: chamberPressureA = 0
3.01 s <= G < 3.5 s: @assert sensorFault == 0
3.5 s <= G < 4 s: chamberPressureA = 0
G == 3.51 s: @assert sensorFault == 0
G == 3.52 s: @assert sensorFault == 1
G == 4 s: @assert sensorFault == 0
4.5 s <= G < 5 s: chamberPressureB = 70
4.52 s <= G < 5 s: @assert sensorFault == 1
G == 5 s: @assert sensorFault == 0

# Stuck: a second is 100 samples that are the same.
5 s <= G < 7 s: chamberPressureA = 1
5 s <= G < 5.99 s: @assert sensorFault == 0
G == 5.99 s: @assert sensorFault == 1
G == 7 s: @assert sensorFault == 0
7 s <= G < 9 s: chamberPressureB = 1
G == 7.98 s: @assert sensorFault == 0
G == 7.99 s: @assert sensorFault == 1
9 s <= G < 11 s: tankPressure = 40
G == 9.98 s: @assert sensorFault == 0
G == 9.99 s: @assert sensorFault == 2
11 s <= G < 13 s: lineTemperature = 290
G == 11.99 s: @assert sensorFault == 3
13 s <= G < 15 s: flow = 0
G == 13.98 s: @assert sensorFault == 0
G == 13.99 s: @assert sensorFault == 4

# Out of their ranges.
16 s <= G < 16.1 s: tankPressure = 0
16.02 s <= G < 16.1 s: @assert sensorFault == 2
16.5 s <= G < 16.6 s: lineTemperature = 0
16.52 s <= G < 16.6 s: @assert sensorFault == 3
17 s <= G < 17.1 s: flow = 2
17.02 s <= G < 17.1 s: @assert sensorFault == 4
17.1 s <= G < 17.2 s: @assert sensorFault == 0

# The two in the chamber disagree: five steps.
18 s <= G < 18.1 s: chamberPressureA = 5 + G / 1000000
G == 18.03 s: @assert sensorFault == 0
18.04 s <= G < 18.1 s: @assert sensorFault == 5

# The computer is late: ten steps of a hundred are forgiven.
19 s <= G < 19.11 s: overruns = overruns + 1
G == 19.09 s: @assert sensorFault == 0
19.1 s <= G < 19.99 s: @assert sensorFault == 6
G == 21 s {
    @assert sensorFault == 0
    @stop
}
