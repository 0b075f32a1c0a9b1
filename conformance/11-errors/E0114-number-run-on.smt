spec 1.16   A number directly followed by a letter or digit that cannot belong to it is an error.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 2nd                 #! E0114 begins with a letter
F64 p
[Hold]
.step
    x = 5psi            #! E0114 only times have units
    x = 0x1G            #! E0114 'G'
    x = 2p              #! E0114 'p'
    T > 5s: x = 1       #! E0114 's'
