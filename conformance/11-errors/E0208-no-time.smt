spec 5.3   An element G is required.
-- app.sm --
[state_vector]        #! E0208 the machine has no element 'G' for the time; list U64 G, or mark the element that holds the time with @alias G
U32 S
U64 time
[Hold]
.step
    time = 5
