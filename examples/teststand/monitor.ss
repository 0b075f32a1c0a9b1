# Sensors with realistic noise; one after the other breaks and is repaired.

[options]
delta_t 10

[all_states]
true {
    chamberPressureA = 1 + G / 1000000
    chamberPressureB = 1 + G / 1000000
    tankPressure     = 40 + G / 1000000
    lineTemperature  = 290 + G / 1000000
    flow             = G / 1000000
}
G < 3000: @assert sensorFault == 0

# Nothing read, for two steps and then for three.
3000 <= G <= 3010: chamberPressureA = 0
3010 <= G < 3500: @assert sensorFault == 0
3500 <= G < 4000: chamberPressureA = 0
G == 3510: @assert sensorFault == 0
G == 3520: @assert sensorFault == 1
G == 4000: @assert sensorFault == 0
4500 <= G < 5000: chamberPressureB = 70
4520 <= G < 5000: @assert sensorFault == 1
G == 5000: @assert sensorFault == 0

# Stuck: a second is 100 samples that are the same.
5000 <= G < 7000: chamberPressureA = 1
5000 <= G < 5990: @assert sensorFault == 0
G == 5990: @assert sensorFault == 1
G == 7000: @assert sensorFault == 0
7000 <= G < 9000: chamberPressureB = 1
G == 7980: @assert sensorFault == 0
G == 7990: @assert sensorFault == 1
9000 <= G < 11000: tankPressure = 40
G == 9980: @assert sensorFault == 0
G == 9990: @assert sensorFault == 2
11000 <= G < 13000: lineTemperature = 290
G == 11990: @assert sensorFault == 3
13000 <= G < 15000: flow = 0
G == 13980: @assert sensorFault == 0
G == 13990: @assert sensorFault == 4

# Out of their ranges.
16000 <= G < 16100: tankPressure = 0
16020 <= G < 16100: @assert sensorFault == 2
16500 <= G < 16600: lineTemperature = 0
16520 <= G < 16600: @assert sensorFault == 3
17000 <= G < 17100: flow = 2
17020 <= G < 17100: @assert sensorFault == 4
17100 <= G < 17200: @assert sensorFault == 0

# The two in the chamber disagree: five steps.
18000 <= G < 18100: chamberPressureA = 5 + G / 1000000
G == 18030: @assert sensorFault == 0
18040 <= G < 18100: @assert sensorFault == 5

# The computer is late: ten steps of a hundred are forgiven.
19000 <= G < 19110: overruns = overruns + 1
G == 19090: @assert sensorFault == 0
19100 <= G < 19990: @assert sensorFault == 6
G == 21000 {
    @assert sensorFault == 0
    @stop
}
