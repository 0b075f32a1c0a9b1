spec 6.8   A .step that .entry never lets run draws a warning.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Choose]
.step                         #! W0505 'Choose'
    -> Lost
.entry
    x > 5: -> Run
    else: -> Choose
[Run]
.entry
    x > 5: -> Choose
.step
    x = 1
[Lost]                        # a note of W0505 says so
