spec 8.71, 8.75, 8.76, 8.77   A handshake: the ground asks, the rocket answers at half the rate, and each waits for the other.

-- stand.app --
[options]
state_vector "stand.sv"
time time 1 ms

[stand]
every 10 ms:
    machine ground "ground.sm"
every 20 ms:
    machine rocket "rocket.sm"
-- stand.sv --
[Stand]
U64  time
U32  groundState
U32  rocketState
bool go
bool request
bool ready
F64  pressure
bool heater
U32  lost
-- ground.sm --
[state_vector]
U64  time        @alias G
U32  groundState @alias S
bool go          @read_only
bool request
bool ready       @read_only
U32  lost

[Idle] @safe
.step
    go: -> Asking

[Asking]
.entry
    request = true
.step
    ready: -> Agreed
    T >= 500: -> Lost
.exit
    request = false

[Agreed] @safe

[Lost] @abort @safe
.entry
    lost = lost + 1
-- rocket.sm --
[state_vector]
U64  time        @alias G
U32  rocketState @alias S
bool request     @read_only
bool ready
F64  pressure    @read_only
bool heater

[Cold] @safe
.step
    request: -> Warming

[Warming]
.entry
    heater = true
.step
    pressure > 800: -> Warm
    not request: -> Cold
.exit
    heater = false

[Warm] @safe
.entry
    ready = true
-- agreed.ss --
# The tank warms by 10 kPa in each tick in which the heater is on.
[all_states]
G == 0: pressure = 500
G == 100: go = true
heater: pressure = pressure + 10
true: @assert not heater or rocket.S == Warming
G == 100: @expect ground.S == Agreed within 450 "the handshake ends"

[ground.Asking]
ground.T == 0: @assert request and not ready

[rocket.Warming]
rocket.T == 0: @assert ground.S == Asking and heater
true: @assert G == 20 * floor(G / 20)

[ground.Agreed]
ground.T == 0: @assert rocket.S == Warm and ready and not request
ground.T == 20: @stop
-- lost.ss --
# The heater is broken: the ground gives up, and the rocket turns its heater off.
[all_states]
G == 100: go = true
true: @assert not ready

[ground.Lost]
ground.T == 0: @assert lost == 1 and not request
ground.T == 100 {
    @assert rocket.S == Cold and not heater
    @stop
}
