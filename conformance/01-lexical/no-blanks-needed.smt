spec 1.4  Blanks are needed only where two words would run together.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y

[Run]
.step
    x=1+2*3
    if(x==7){y=x-1}

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x==7
    @assert y==6
    @stop
}
