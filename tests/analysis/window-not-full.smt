# Statistics that decide in the first steps, with fewer samples than their window holds.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
bool armed @read_only
[First]
.entry
    roll_avg(p, 10) > 5: -> Wait                  #! W0965 'roll_avg(p, 10)' has 1 of 10 samples
.step
    armed and roll_min(q, 4) > 1: -> Wait         #! W0965 has 1 of 4
    T > 500 and roll_avg(p, 9) > 4: -> Wait       # the number of steps is unknown
[Wait]
.step
    roll_avg(p, 10) > 5: -> First                 #! W0965 has 2 of 10
