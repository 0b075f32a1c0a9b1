spec 3.11   A condition compares with one value at a time.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    p > 1: -> Vent
[Vent]
.entry
-- app.ss --
[options]
delta_t 10
[all_states]
S in (Hold, Vent): v = 1                     #! E0329 write S == Hold or S == Vent
state in (Hold, Vent): v = 1                 #! E0329 write S == Hold or S == Vent
G == 0: @assert S in (Hold, Vent) "text"     #! E0329 write S == Hold or S == Vent
G == 10: @assert S == Hold, Vent             #! E0330 write S == Hold or S == Vent
G == 20: @expect S in (Vent) within 1 s      #! E0329 write S == Vent
G == 30: @stop p > 5                         #! E0330 as in: p > 5: @stop
