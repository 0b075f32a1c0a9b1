# The valve opens, and the line does not get cold: after 60 pulses there is no 61st.

[options]
delta_t 50

[all_states]
G == 0 {
    chill        = true
    lineTemp     = 290
    linePressure = 1
}
true: @assert pulses <= 60 and S != Flow

[Abort]
true: @assert pulses == 60 and not sensorFailed and not chillValve
T == 100: @stop
