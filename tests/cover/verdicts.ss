[all_states]
true: go = false
at 10 s: @stop
