spec 8.31  A text and a requirement appear at most once, in quotes and as a name; a print has no requirement.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
bool open
[Hold]
.step
    open = x > 5
    x == 100: -> Vent
[Vent]
.step
    open = false
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: @assert open "a" "b"          #! E0348 text
G == 0: @assert open @req R1 @req R2  #! E0348 requirement
G == 0: @assert open @req "R1"        #! E0347
G == 0: @print x @req R1              #! E0366
G == 0: @assert open, "late"          #! E0349
G == 0: @expect open "late"           #! E0345
G == 10: @stop
