spec 5.67, 13.3  A definition that requirements use is used. One that only an unused definition uses is not.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[define]
limit = 350
hot = p > limit
colder = p < 100        #! W0212 'colder' is never used
cold = colder           #! W0212 'cold' is never used
very_hot = p > 1000     @allow(unused-definition, "R2")
noted = p > 1001        @allow(unused-definition, "another file")

[A] @safe
.step
    on = p > 10

-- app.rq --
R1 "hot"       always hot implies on
R2 "very hot"  always very_hot implies on

-- app.ss --
[all_states]
G == 0: p = 400
G == 10: p = 4000
G == 20: @stop
