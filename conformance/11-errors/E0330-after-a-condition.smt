spec 1.27   Statements that share a line after a condition's colon belong in braces, whatever separates them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool b @read_only
U8 code
[Idle]
.step
    p > 50: code = 1, -> Abort                  #! E0330 in braces
    p > 50: code = 1 -> Abort                   #! E0330 in braces
    p > 50: code = 1 and then -> Abort          #! E0330 in braces
    p > 50: code = 1 then -> Abort              #! E0330 in braces
    p > 50: code = 1 and -> Abort               #! E0312 in braces
    p > 50: code = 1 && -> Abort                #! E0312 in braces  #! E0107 and
    p > 50: code = 1, code = 2; -> Abort        #! E0330 in braces
    p > 50: code = 1 code = 2 -> Abort          #! E0330 in braces
    b: code = 1
    else: code = 2, -> Abort                    #! E0330 in braces
    b { code = 5, code = 6 }                    #! E0330 each statement
    code = 7, code = 8, code = 9                #! E0330 each statement
    code = 7 -> Abort                           #! E0330 condition: -> State
    p > 50: code = 1 { -> Abort }               #! E0330
    p > 50 and -> Abort                         #! E0312 write ':' instead of 'and'
    -> Abort when p > 50                        #! E0330 the condition comes first
    unless p > 50: code = 1                     #! E0329 the opposite condition
    p > 50: code = 1 b                          #! E0330
[Abort]
