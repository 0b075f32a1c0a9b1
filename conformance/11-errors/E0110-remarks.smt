spec 1.4   Comments begin with #; a comment sign of another language is reported once, and the edit writes #.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x -- metres per second           #! E0110
F64 y @range 0 5 % pressure   #! E0110
bool on
F64 limit -- hm               #! E0110
-- hm                         #! E0110
[Hold]
.step
    -- comment                #! E0110
    -- and another one        #! E0110
    % comment                 #! E0110
    on = true % comment       #! E0110
    on = true // comment      #! E0110
    on = true -- set it       #! E0110
    x = p -- set it           #! E0110
    -> Hold -- done           #! E0110
    /* comment */             #! E0110
    x = x % p                 #! E0108 remainder
