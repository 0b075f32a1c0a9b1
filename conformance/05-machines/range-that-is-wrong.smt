spec 5.47  A range is not empty, consists of numbers and belongs to a number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @range 40 0         #! E0220 40 is more than 0
F64 b @range 0 -40        #! E0220 0 is more than -40
bool c @range 0 1         #! E0222 'c'
F64 d @range              #! E0377 the lowest value
F64 e @range 0            #! E0377 the highest value
F64 f @range 0, 40        #! E0377 found ','
F64 g @range lo hi        #! E0377 found 'lo'
F64 h @range (0 40)       #! E0377 found '('
F64 i @range 0 40 @range 0 50     #! E0361 duplicate '@range' on 'i'
F64 j @range 0 40 50      #! E0330
[local]
F64 k = 0 @range 0 1      #! E0362 '@range'
[A]
.step
    j = 1
