spec 5.3   An element G is required.
-- app.sm --
[state_vector]        #! E0208 no element is called 'G'
U32 S
U64 time
[Hold]
.step
    time = 5
