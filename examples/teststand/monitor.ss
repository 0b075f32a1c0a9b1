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
from 3.01 s to 3.5 s: @assert sensorFault == 0
from 3.5 s to 4 s: chamberPressureA = 0
at 3.51 s: @assert sensorFault == 0
at 3.52 s: @assert sensorFault == 1
at 4 s: @assert sensorFault == 0
from 4.5 s to 5 s: chamberPressureB = 70
from 4.52 s to 5 s: @assert sensorFault == 1
at 5 s: @assert sensorFault == 0

# Stuck: a second is 100 samples that are the same.
from 5 s to 7 s: chamberPressureA = 1
from 5 s to 5.99 s: @assert sensorFault == 0
at 5.99 s: @assert sensorFault == 1
at 7 s: @assert sensorFault == 0
from 7 s to 9 s: chamberPressureB = 1
at 7.98 s: @assert sensorFault == 0
at 7.99 s: @assert sensorFault == 1
from 9 s to 11 s: tankPressure = 40
at 9.98 s: @assert sensorFault == 0
at 9.99 s: @assert sensorFault == 2
from 11 s to 13 s: lineTemperature = 290
at 11.99 s: @assert sensorFault == 3
from 13 s to 15 s: flow = 0
at 13.98 s: @assert sensorFault == 0
at 13.99 s: @assert sensorFault == 4

# Out of their ranges.
from 16 s to 16.1 s: tankPressure = 0
from 16.02 s to 16.1 s: @assert sensorFault == 2
from 16.5 s to 16.6 s: lineTemperature = 0
from 16.52 s to 16.6 s: @assert sensorFault == 3
from 17 s to 17.1 s: flow = 2
from 17.02 s to 17.1 s: @assert sensorFault == 4
from 17.1 s to 17.2 s: @assert sensorFault == 0

# The two in the chamber disagree: five steps.
from 18 s to 18.1 s: chamberPressureA = 5 + G / 1000000
at 18.03 s: @assert sensorFault == 0
from 18.04 s to 18.1 s: @assert sensorFault == 5

# The computer is late: ten steps of a hundred are forgiven.
from 19 s to 19.11 s: overruns = overruns + 1
at 19.09 s: @assert sensorFault == 0
from 19.1 s to 19.99 s: @assert sensorFault == 6
at 21 s: @assert sensorFault == 0
at 21 s: @stop
