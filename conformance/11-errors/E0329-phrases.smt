spec 1.21   Operators in words are read as ours, in any case of the letters.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
bool b
[Hold]
.step
    p is not equal to 3: x = p                #! E0329 write !=
    p is equal to 3: x = p                    #! E0329 write ==
    p is greater than or equal to 3: x = p    #! E0329 write >=
    p is less than or equal to 3: x = p       #! E0329 write <=
    p is greater than 3: x = p                #! E0329 write >
    p is more than 3: x = p                   #! E0329 write >
    p is larger than 3: x = p                 #! E0329 write >
    p is higher than 3: x = p                 #! E0329 write >
    p is less than 3: x = p                   #! E0329 write <
    p is smaller than 3: x = p                #! E0329 write <
    p is lower than 3: x = p                  #! E0329 write <
    p is at least 3: x = p                    #! E0329 write >=
    p is at most 3: x = p                     #! E0329 write <=
    p is above 3: x = p                       #! E0329 write >
    p is below 3: x = p                       #! E0329 write <
    p is not 3: x = p                         #! E0329 write !=
    p equals not 3: x = p                     #! E0329 write !=
    p eq not 3: x = p                         #! E0329 write !=
    p is 3: x = p                             #! E0329 write ==
    p equals 3: x = p                         #! E0329 write ==
    p eq 3: x = p                             #! E0329 write ==
    p ne 3: x = p                             #! E0329 write !=
    p gt 3: x = p                             #! E0329 write >
    p lt 3: x = p                             #! E0329 write <
    p ge 3: x = p                             #! E0329 write >=
    p le 3: x = p                             #! E0329 write <=
    p > 5 do x = 1                            #! E0329 ':'
