spec 3.17   The smallest or largest of several values needs nested calls.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[Idle]
.step
    x = max(p, 1, 2)                #! E0401 write max(max(p, 1), 2)
    x = min((p + 1), 2, abs(p), 4)  #! E0401 write min(min(min((p + 1), 2), abs(p)), 4)
    x = max(min(p, 1, 2), 3, 4)     #! E0401 max takes #! E0401 min takes
    x = min(p)                      #! E0401 roll_min(p, n)
    x = round(p + 1, 2)             #! E0401 round((p + 1) * 100) / 100
    x = clamp(p, 1)                 #! E0401 write clamp(x, lo, hi)
