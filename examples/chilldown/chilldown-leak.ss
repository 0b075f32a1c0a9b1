# The valve opens, and the line does not get cold: after 60 pulses there is no 61st.

include "cold-start.ss"

[all_states]
true: @assert pulses <= 60 and S != Flow

[Abort]
true: @assert pulses == 60 and not sensorFailed and not chillValve
T == 100: @stop
