# A proof splits a block by the last value of each bool that it stores.  Here a is stored twice: that both values are the same is never assumed.
args prove a.sm a.rq --effort=1 2>&1 | grep '^  R'

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 q @read_only
bool a
bool b
[Run] @safe
.step
    a = p > 5
    b = a or q < 3
    a = q > 5
-- a.rq --
R1 "the first value"    always p > 5 implies a
R2 "and back"           always a implies p > 5
R3 "the other one"      always not b implies p <= 5
R4 "the last value"     always q > 5 implies a
-- stdout --
  R1  violated            the first value
  R2  violated            and back
  R3  no violation found  the other one
  R4  proved              the last value
