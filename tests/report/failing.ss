# It fails.
[options]
delta_t 10
[all_states]
G < 50: p_lt_gt = 0
G >= 50: p_lt_gt = 7
true: @assert p_lt_gt < 1
G == 1000: @stop
