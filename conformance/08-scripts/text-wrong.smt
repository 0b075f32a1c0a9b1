spec 8.30  A text and a requirement appear at most once, in quotes and as a name; a print has no requirement.

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
G == 0: @assert open "a" "b"          #! E0397 text
G == 0: @assert open @req R1 @req R2  #! E0397 requirement
G == 0: @assert open @req "R1"        #! E0396
G == 0: @print x @req R1              #! E0399
G == 0: @assert open, "late"          #! E0398
G == 0: @expect open "late"           #! E0394
G == 10: @stop
