spec 5.21, 5.56  [options] of a machine contains time_unit and step, each once; no other option.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[options]
lock                    #! E0372 'lock' is an option of a state vector (.sv)
delta_t 10              #! E0372
init_state Run          #! E0372
time_unit ms
step 20 ms
time_unit us            #! E0390 duplicate option 'time_unit'

[Run]
.step
    x = 1

[options]               #! E0302
step 10 ms              #! E0390
