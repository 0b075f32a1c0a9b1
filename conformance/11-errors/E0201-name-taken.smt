spec 5.15   In a machine a name means one thing; the error is at the second, with a note at the first.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 pressure
F64 flow  @alias q
F64 rate  @alias pressure     #! E0201 the name 'pressure' is already used: it is an element
[local]
F64 q = 1                     #! E0201 'q' is declared here
F64 limit = 800
U8  limit = 5                 #! E0201 the name 'limit' is already used: it is a local
[Hold]
.step
    flow = pressure + rate + q + limit
