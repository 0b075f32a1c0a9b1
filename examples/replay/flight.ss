# The recorded flight, as it was. The flight computer logged a row about every 20 ms, with everything that loggers do:
# rows twice, a clock that was set back, half a second without rows, cells without a value.

[data]
file "flight.csv"
time "t_ms" ms
on_bad_time skip
hold
altitude = "BARO_ALT"
# The flown software fired two periods before this one, whose median of the altitude is longer.
@compare drogueCharge "DROGUE_CMD" delay 40 ms

[Pad]
true: @assert not drogueCharge

[Ascent]
true: @assert not drogueCharge
T == 0: @assert 3 s < G < 5 s

[all_states]
G == 10 s: @assert S == Ascent "in flight"
G == 25 s: @assert S == Descent "under the drogue"
G == 25 s: @stop
