spec 2.27  Capital and small letters differ. An unknown name is a warning, and its value has no unit.
warn no-all units unknown-unit

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @unit kpa            #! W0451 did you mean 'kPa'
F64 b @unit furlong/h      #! W0451 unknown unit 'furlong'
F64 c @unit mPa
F64 d @unit MPa
F64 e @unit %              #! W0451 did you mean 'percent'
F64 f @unit m

[Run] @safe
.step
    f = b
    c = d                        #! W0448 1 MPa is 1e+09 mPa
    a = e
