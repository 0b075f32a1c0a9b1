spec 5.58  Analyses cannot count with another step than that of the machine.
advance 10

-- app.sm --
[options]
step 20 ms            #! E0706 --step is 10, but the machine declares a step of 20
[state_vector]
U64 G
U32 S
F64 x
[Run]
.step
    x = roll_avg(T, 40 ms)
