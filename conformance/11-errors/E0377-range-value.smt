spec 5.47   A range is two numbers.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @range -G 40        #! E0377 expected a number, the lowest value of '@range', found 'G'
F64 b @range 0 to 40      #! E0377 write @range 0 40
F64 c @range 0 true       #! E0377 found 'true'
F64 d @range 0 @alias e   #! E0377 found '@alias'
F64 f @range 0..40        #! E0377 write @range 0 40
F64 g @range -1 1e400     #! E0112
F64 i @range 15 s 40 s    #! E0377 without a unit, in the time_unit of the machine
F64 h @range 0 40
[A]
.step
    h = a + b + c + d + e + i
