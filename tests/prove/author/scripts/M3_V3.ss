[all_states]
at 0 {
    armKey = true
    baroAltitude = -1/0
}
at 40 ms: accelZ = 200
at 40 ms: baroAltitude = 1/0       # step 4: two of each, so the median is NaN
at 2 s: @stop
