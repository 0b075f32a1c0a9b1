spec 2.25  A text that is no unit, no text, a blank in it, and the unit of a bool are errors.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit m//s         #! E0441 expected the name of a unit
F64 b @unit m/s^        #! E0441 expected a number
F64 c @unit (m          #! E0441 expected ')'
F64 d @unit             #! E0440 expected a unit
bool f @unit m          #! E0442 a bool
F64 g @unit m^100       #! E0441 at most 99
F64 h @unit ((((((((((m))))))))))       #! E0441 parentheses
F64 i @unit m.s         #! E0441
F64 j @unit m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m*m   #! E0441 at most 80 characters
F64 k @unit Tm^99        #! E0441 a smaller unit
F64 l @unit m/s2^2       #! W0451 did you mean 's^2'

[Run] @safe
