# On the pad the accelerometer says what it likes: as long as the plug is in, nothing has been launched.

[all_states]
at 0: umbilical = true
true: acceleration = 60
true: @assert S == Pad and not mayBrake and not deployParachutes
at 60 s: @stop
