# A record of the test stand, whose data acquisition wrote semicolons, decimal commas and counts of its converter.

[options]
delta_t 20

[data]
file "stand.csv"
time "time_s" s
linear
pressure = "PT-101" @scale 0.01 @offset -1        # counts to bar
# The old controller commanded the valve in the same periods, so the two must agree at every step.
@compare ventOpen "VENT_CMD"

[all_states]
G == 9900: @assert 23.5 < pressure < 26.5
G == 9900: @stop
