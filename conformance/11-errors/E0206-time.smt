spec 5.2, 5.3   G of another type than the state vector has is one mistake, not two.
-- app.sv --
[Main]
U64 G
U32 S
-- app.sm --
[state_vector]
F64 G      #! E0206 element 'G' is U64 in the state vector, not F64
U32 S
[Hold]
