# <script>alert("script")</script> `x` & more
[options]
delta_t 10
[all_states]
true: p_lt_gt = 10 * (G / 1000 - floor(G / 1000)) - 3
G == 500: valve = true
G == 20000: @assert p_lt_gt < 100   # </p>
G == 20000: @stop
