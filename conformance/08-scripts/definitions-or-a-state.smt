spec 8.22  A section of a state named define.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 x
[define]
.step
    x = 1
-- app.ss --
[options]
delta_t 1
[define]
p = 4                    #! E0380
@stop = 1                #! E0391
