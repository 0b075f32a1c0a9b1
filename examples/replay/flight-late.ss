# The same flight with an altimeter that died 8 s after the start of the record: what the timer does then. The columns
# of the record are inputs like any others, and an input of the script overwrites them.

[data]
file "flight.csv"
time "t_ms" ms
on_bad_time skip
altitude = "BARO_ALT"

[all_states]
G >= 8 s: altitude = 0
G == 19 s: @assert S == Descent and drogueCharge
G == 19 s: @stop

[Descent]
T == 0: @assert G > 18 s "by the timer"
