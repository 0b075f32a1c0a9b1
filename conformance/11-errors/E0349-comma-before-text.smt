spec 8.31  The text of an item follows its condition directly, without a comma.

-- app.sm --
[state_vector]
U64 G
U32 S
bool open
[Hold]
.step
    open = true
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: @assert open, "late"          #! E0349
G == 10: @stop
