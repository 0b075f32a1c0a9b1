spec 3.12, 3.13   `not` reaches to the next value only; a warning offers both readings.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
[Hold]
.step
    not a == b: -> Hold             #! W0401 (not a) == b
    not a < b: -> Hold              #! W0401 not (a < b)
    !a + b: -> Hold                 #! W0401 not (a + b)
    c and not a < b <= c: -> Hold   #! W0401 not (a < b <= c)
    not a + b > c: -> Hold          #! W0401 not (a + b > c)
    c = max(not a * b, c)           #! W0401
    not (a == b): -> Hold
    (not a) == b: -> Hold
    not a and b: -> Hold
    not a or not b: -> Hold
    a == not b: -> Hold
    not not a: -> Hold
