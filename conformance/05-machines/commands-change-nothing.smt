spec 5.44, 5.53  A command is an element like others: it is read, and a machine may assign one that is not read-only.

-- app.sv --
[R]
U64 G
U32 S
bool go @command
U8 order @command @range 0 9
F64 trim
F64 seen
-- app.sm --
[state_vector]
U64 G
U32 S
bool go @read_only
U8 order @read_only @command
F64 trim @command
F64 seen

[Idle]
.step
    go: -> Run

[Run]
.entry
    trim = order
.step
    seen = trim + order
    trim = trim + 1
    not go and order == 7: -> Idle

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: trim = 5
G == 0: @assert S == 1 and trim == 5 and seen == 0
G == 1: go = true
G == 1: order = 3
G == 1: @assert S == 1 and trim == 5
G == 2: @assert S == 2 and trim == 4 and seen == 6
G == 3: order = 200
G == 3: @assert S == 2 and trim == 5 and seen == 204
G == 4: go = false
G == 4: order = 7
G == 4: @assert S == 2 and trim == 6 and seen == 12
G == 5: @assert S == 1 and trim == 6
G == 5: @stop
