spec 1.4  Tabs and any number of blanks separate words; indentation means nothing.

-- app.sm --
[state_vector]
U64 G
U32 S
F64		x
F64   	  y

[Run]
.step
    	x	=	1	+	2
             if	x == 3	{
     y = 4	
    			}

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 3
    @assert y == 4
    @stop
}
