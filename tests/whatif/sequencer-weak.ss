# A weak motor: a flight to 300 m.  Its height and speed are variables of the script, so no fault of a sensor changes the flight.
[local]
F64  height = 0
F64  speed = 0
F64  force = 0
bool isOut = false

[all_states]
G == 0:       voltage = 12.4
G == 1 s:     breakwire = true
from 2 s to 3.2 s: force = 60
after 3.2 s:  force = -9.8 - 0.0004 * speed * abs(speed)
isOut:        force = -9.8 - 0.02 * speed * abs(speed)
main:         isOut = true
drogue and G > 2 s {
    isOut = true
    drogueOut = true
}
height <= 0 and G > 5 s {
    force = 0
    speed = 0
}
true {
    speed = speed + force * 0.01
    height = max(0, height + speed * 0.01)
    altitude = height + noise(0.3)
    acceleration = force + noise(0.5)
    tilt = 3 + noise(0.2)
}
at 1.9 s:     @assert S == Armed
at 3 s:       @assert S == Boost
at 6 s:       @assert S == Coast and not drogue
at 60 s:      @assert S == Landed
at 60 s:      @stop
