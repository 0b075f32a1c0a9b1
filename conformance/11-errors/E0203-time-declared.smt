spec 5.6, 5.15   T exists in every machine: no element, alias or local can bear the name.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 T                    #! E0203
F64 temperature @alias T #! E0203
[local]
F64 T = 20               #! E0203
[Hold]
.step
    temperature = T
