spec 1.25   The labels of other languages, and what they are here.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
bool b
[S0]
.start             #! E0308 did you mean '.entry'?
    x = p
[S1]
.enter             #! E0308 did you mean '.entry'?
    x = p
[S2]
.init              #! E0308 did you mean '.entry'?
    x = p
[S3]
.begin             #! E0308 did you mean '.entry'?
    x = p
[S4]
.on_entry          #! E0308 did you mean '.entry'?
    x = p
[S5]
.loop              #! E0308 did you mean '.step'?
    x = p
[S6]
.run               #! E0308 did you mean '.step'?
    x = p
[S7]
.do                #! E0308 did you mean '.step'?
    x = p
[S8]
.update            #! E0308 did you mean '.step'?
    x = p
[S9]
.during            #! E0308 did you mean '.step'?
    x = p
[S10]
.main             #! E0308 did you mean '.step'?
    x = p
[S11]
.leave            #! E0308 did you mean '.exit'?
    x = p
[S12]
.end              #! E0308 did you mean '.exit'?
    x = p
[S13]
.stop             #! E0308 did you mean '.exit'?
    x = p
[S14]
.on_exit          #! E0308 did you mean '.exit'?
    x = p
