spec 1.21   An operator that may have been meant for bits is not replaced by a condition without confirmation.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only
U8 status @read_only
U8 mask
bool x
[Hold]
.step
    p > 1 & armed: x = 1                #! E0107 write and
    armed and x | armed: x = 1          #! E0107 for the bits
    (p > 1) | armed: x = 1              #! E0107 write or
    p > 1 & (status & mask): x = 1      #! E0107 write and #! E0107 for the bits
    armed & p > 1: x = 1                #! E0107 for the bits
    status & mask: x = 1                #! E0107 for the bits
    (status & mask) == 4: x = 1         #! E0107 for the bits
    status == 4: x = armed | p          #! E0107 for the bits
    ~armed: x = 1                       #! E0107 write not
    mask = ~status                      #! E0107 for the bits
    p > 5 && status & mask: x = 1       #! E0107 write and #! E0107 for the bits
    p > 5 & status & mask: x = 1        #! E0107 for the bits #! E0107 for the bits
    p > 1 | p < 0 && armed: x = 1       #! E0107 for the bits #! E0107 write and
