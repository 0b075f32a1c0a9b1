spec 1.27   After a condition's colon the advice is braces, since a statement on a line of its own would lose the condition.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool b @read_only
U8 code
[Idle]
.step
    p > 50: code = 1; -> Abort                  #! E0109 in braces
    p > 40: code = 1; code = 2; -> Abort;       #! E0109 in braces
    p > 30: -> Abort;                           #! E0109 leave it out
    p > 20: code = (p +                         # a value on two lines
      3); code = 4                              #! E0109 inside braces
    p > 10: code = 1; -> Abort # why            #! E0109 in braces
    else: code = max(p, 3); -> Idle             #! E0109 in braces
    b { p > 10: code = 1; -> Abort }            #! E0109 in braces
    b: p > 10: code = 1; -> Abort               #! E0109 in braces
    if b: code = 1; code = 2 else: code = 3     #! E0109 in braces
    code = 1; p > 5: code = 2; -> Abort         #! E0109 each statement #! E0109 in braces
    p > 10: code = 1; b: -> Abort               #! E0109 in braces
	b: code = 5; code = 6                       #! E0109 in braces
    b { code = 5; code = 6 }                    #! E0109 each statement
    b { code = 5; }                             #! E0109 leave it out
    if b then code = 5; -> Abort                #! E0109 inside braces #! E0329 :
    p > 10: code = 1; else: -> Abort            #! E0109 leave it out
    p > 5; code = 1; -> Abort                   #! E0327 needs ':' and a statement #! E0109 inside braces #! E0109 inside braces
    code = 7; -> Abort                          #! E0109 each statement
[Abort]
