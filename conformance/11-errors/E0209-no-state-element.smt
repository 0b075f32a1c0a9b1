spec 5.4   An element S is required.
-- app.sm --
[state_vector]        #! E0209 the machine has no element 'S' for the state; list U32 S, or mark the element that is to hold the state with @alias S
U64 time  @alias G
U32 state
[Hold]
