# An equality that an inequality beside it makes superfluous, in machines and in asserts of scripts. The same constant, other values, and definitions
# that overlap are meant, or are reported otherwise.
warn all

-- app.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
U8   code  @read_only
U8   other @read_only
bool out
[define]
A = 1
B = 2
isA = code == A
[One] @safe
.step
    code == A or code != B: out = true             #! W0522 'code == A' changes nothing here
    code != A and code == B: out = false           #! W0522 'code != A' changes nothing here
    (code == A or other != B) and code != 3: out = true
    code == A or code == B: out = false
    code != A and code != B: out = true
    isA or code != B: out = false
    code == A and code < 3: out = true
    other == 3 or out or B != other: out = false   #! W0522 'other == 3' changes nothing here
