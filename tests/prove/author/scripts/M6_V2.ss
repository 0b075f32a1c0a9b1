[all_states]
at 0: chamberP = 2
at 1040 ms: sepSwitch = true
[Ullage]
T == 300: sepSwitch = false
[all_states]
at 4 s: @stop
