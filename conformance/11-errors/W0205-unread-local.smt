spec 5.9   A local that is written and never read, or read by nothing but itself, draws a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
[local]
F64 start = 0                 #! W0205 'start'
F64 count = 0                 #! W0206 'count'
[Hold]
.entry
    start = G
    count = count + 1
