# Whatever happens at the pad, without the key nothing fires.

[options]
delta_t 20

[all_states]
true: acceleration = 9.8
1000 < G < 4000: acceleration = 100
true: @assert S == 1 and not drogueCharge and not mainCharge
G == 60000: @stop
