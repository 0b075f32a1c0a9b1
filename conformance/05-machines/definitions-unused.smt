spec 5.67  Without requirements, a definition that only they could use is not used.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[define]
limit = 350             #! W0212 'limit' is never used
hot = p > limit         #! W0212 'hot' is never used
known = p > 1000        @allow(unused-definition, "R2 of app.rq")

[A] @safe
.step
    on = p > 10
