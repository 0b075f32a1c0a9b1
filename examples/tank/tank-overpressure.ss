# The vent does not help, and the pressure rises beyond the band.

[options]
delta_t 10

[all_states]
G == 0:   tankPressure = 700
G > 0:    tankPressure = tankPressure + 10
G == 200 {
    @assert S == Abort "the tank is given up" @req R2
    @assert valveOpen  "the vent is open"     @req R3
    @stop
}
