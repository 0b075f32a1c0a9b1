spec 13.4  A window in time needs the step of the machine.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[A]
.step
    p > 1: -> A

-- app.rq --
R1 "a"  never roll_avg(p, 100 ms) > 3  #! E0411
