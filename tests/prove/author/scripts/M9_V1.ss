[all_states]
at 0: start = true
at 300 ms: abortCmd = true
at 2 s: @stop
