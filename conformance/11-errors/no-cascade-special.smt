spec 5.3, 5.4   G and S are not reported as missing where a declaration could not be read.
-- app.sm --
[state_vector]
U64 time @alais G          #! E0360
U32 S
[Hold]
.step
    G > 5: -> Hold
