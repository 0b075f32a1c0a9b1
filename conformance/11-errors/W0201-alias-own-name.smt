spec 5.16   An alias equal to the element's own name draws a warning.
-- app.sm --
[state_vector]
U64 G @alias G        #! W0201
U32 S
[Hold]
