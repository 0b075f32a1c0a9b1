# A chain that ends, a state that begins again for as long as an input says so, and a cycle that time holds up.
warn no-all never-rests ping-pong
-- app.sm --
[state_vector]
U64  G
U32  S
bool go @read_only
bool lamp
[Off] @safe
.step
    go: -> One
[One]
.step
    -> Two
[Two]
.step
    -> Pulse
[Pulse]
.entry
    lamp = not go
.step
    go: -> Pulse
    -> Wait
[Wait]
.step
    T > 100: -> Pulse
