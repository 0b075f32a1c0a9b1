spec 5.38   Lines below a colon that are indented more are its statements, and belong in braces.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool b @read_only
U8 code
[Idle]
.step
    if p > 50:                #! E0316 write '{'
        code = 1
        # and go

        -> Abort              # now
    else:   # not yet         #! E0316 write '{'
        code = 2
    p > 30:                   #! E0316 write '{'
        b:                    #! E0316 write '{'
            code = 3
            code = 4
        -> Abort
    b:                        #! E0316 write '{'
    -> Abort
    b:                        #! E0316 write '{'
        p > 5 {
            code = 5
        }
        code = 6; -> Abort    #! E0109 each statement
    b:                        #! E0316 write '{'
        code = 7
    b:                        #! E0316 write '{'
        code = 8
      .exit
    code = 0
[Abort]
