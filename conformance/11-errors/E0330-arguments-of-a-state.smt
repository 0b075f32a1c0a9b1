spec 1.24   A transition names a state, which has no arguments.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    v == 1: -> Vent(1)      #! E0330 a state takes no arguments: write -> Vent
    v == 2: -> Vent()       #! E0330 write -> Vent
    v == 3: -> Tank Vent    #! E0330 one word, such as Tank_Vent
[Vent]
.entry
[Tank]
.entry
