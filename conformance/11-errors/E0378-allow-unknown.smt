spec 5.49   An @allow names a warning.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @allow(unused-elemnt, "x")          #! E0378 did you mean 'unused-element'?
F64 b @allow(W0203, "x")                  #! E0378 did you mean 'unused-element'?
F64 c @allow(E0203, "x")                  #! E0378 errors cannot be allowed
F64 d @allow(extra, "x")                  #! E0378 unknown warning 'extra'
F64 e @allow(unused, "x")                 #! E0378
F64 f @allow(unused - element, "x")       #! E0378 did you mean 'unused-element'?
[A]
.step
    a = b + c + d + e + f
