# The line was ready and warms up: to 99 K, and the valve opens; to 110 K, and it is not ready any more.

[all_states]
at 0 {
    chill    = true
    lineTemp = 170
}
true: linePressure = 2

[Soak]
true: lineTemp = 170

[Flow]
true: lineTemp = 92
true: @assert not lineReady or T >= 5000

[Ready]
T < 5000: lineTemp = 97                  # between the two limits the valve stays as it is: shut
1000 <= T < 5000: @assert not chillValve
5000 <= T < 6000: lineTemp = 99
5200 <= T < 6000: @assert chillValve
6000 <= T < 7000: lineTemp = 96          # and here: open
6000 <= T < 7000: @assert chillValve
7000 <= T < 8000: lineTemp = 94
7200 <= T < 8000: @assert not chillValve
T == 8000: lineTemp = 120                # a single sample
8000 < T < 9000: lineTemp = 94
T >= 9000: lineTemp = 110
T < 9000: @assert lineReady
true: @assert T <= 9100

[all_states]
at 20 s: @assert S == Flow
at 30 s: @stop
