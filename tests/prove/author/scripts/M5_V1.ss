[all_states]
at 0: go = true
at 100 ms: pumpTemp = -1/0
at 200 ms: pumpTemp = 1/0
at 2 s: @stop
