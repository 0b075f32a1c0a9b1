spec 8.39   Guards by time belong to scripts.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    after 5 s: x = 1            #! E0762 'after' with a time is a guard of scripts
    at 5: x = 1                 #! E0762
    if x > 3: every 10 ms: x = 2   #! E0762
    from 5 s to 6 s { x = 3 }   #! E0762
    x = 4
