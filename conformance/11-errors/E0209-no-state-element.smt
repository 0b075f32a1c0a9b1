spec 5.4   An element S is required.
-- app.sm --
[state_vector]        #! E0209 no element is called 'S'
U64 time  @alias G
U32 state
[Hold]
