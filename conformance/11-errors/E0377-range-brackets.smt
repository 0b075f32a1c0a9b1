spec 2.9   The two numbers of @range have only spaces between them; the edit removes other characters where the meaning is certain.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @range [0, 5]           #! E0377
F64 b @range 0..5             #! E0377
F64 c @range 0, 5             #! E0377
F64 d @range -1.5 to 5        #! E0377
F64 e @range (0 5)            #! E0377
F64 f @range 0,5 10           #! E0377
F64 h @range [0, 5            #! E0377
F64 i @range (0 to 5          #! E0377
F64 g @range 0.5 10
[Hold]
.step
    a = b + c + d + e + f + g + h + i
