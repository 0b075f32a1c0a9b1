spec 5.49   An @allow has a reason.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(dead-code)                   #! E0387
F64 b @allow(dead-code,)                  #! E0387
F64 c @allow(dead-code, "")               #! E0387 what makes it right
F64 d @allow(dead-code, " 	 ")           #! E0387
[A] @allow(dead-code)                     #! E0387
.step
    @allow(dead-code)                     #! E0387
    a = b + c + d
