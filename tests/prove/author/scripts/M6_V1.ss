[all_states]
at 0: chamberP = 2
at 1020 ms: sepSwitch = true        # already before Separate
at 4 s: @stop
