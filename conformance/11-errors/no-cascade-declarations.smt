spec 5.20   What a broken declaration may have declared is not reported as unknown; everything else is.
-- app.sm --
[state_vector]
U64 G
U32 S
F64x pressure              #! E0351
bool valve @alais v        #! E0360
I16 k @alias               #! E0365
[local]
F64 a = 1 +                #! E0312
F64 b                      #! E0355
F64 c = zz                 #! E0204 'zz'
[Hold]
.step
    pressure = presure + v #! E0204 did you mean 'pressure'?
    a = b + c + k
    unknown = roll_avg(1, b)   #! E0204 'unknown'
    -> Nope                #! E0501
