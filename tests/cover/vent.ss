[options]
delta_t 10

[all_states]
G == 0:                 pressure = 0
0 < G <= 200:           pressure = pressure + 40
200 < G <= 400:         pressure = pressure - 40
400 < G <= 600:         pressure = pressure + 40
600 < G <= 800:         pressure = pressure - 40
800 < G:                pressure = pressure + 40
G == 1000: @assert pressure > 0
G == 1000: @stop
