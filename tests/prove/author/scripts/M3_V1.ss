[all_states]
at 0: armKey = true
at 20 ms: accelZ = 200
at 2 s: @stop
