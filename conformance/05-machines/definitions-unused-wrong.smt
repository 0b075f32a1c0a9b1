spec 5.67  The errors of a definition that nothing uses are reported.
warn

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[define]
ok   = roll_avg(x, 3)
much = missing + 1              #! W0212 much  #! E0204 missing
size = roll_avg(x, 0)           #! W0212 size  #! E0405
more = much + 1                 #! W0212 more
[Run]
.step
    x = ok
