[all_states]
at 0 {
    armKey = true
    baroAltitude = 1000
}
at 200 ms: accelZ = 50
at 1 s: accelZ = -100
at 1500 ms: baroAltitude = 500
[Coast]
true: baroAltitude = 500
[DrogueFire]
T == 900: baroAltitude = 100
[Descent]
T == 0: baroAltitude = 5000        # the median is still 100
[all_states]
at 5 s: @stop
