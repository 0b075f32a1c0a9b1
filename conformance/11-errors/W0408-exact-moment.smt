spec 6.5   Waiting for one exact time causes a warning.
analyses on
-- app.sm --
[state_vector]
U64 time @alias G
U32 S
[Hold]
.step
    T == 5000: -> Hold        #! W0408 'T' is possibly never exactly 5000
    100 == time: -> Hold      #! W0408 'time'
    T == 0: -> Hold
    T >= 5000: -> Hold
    S == 2: -> Hold
