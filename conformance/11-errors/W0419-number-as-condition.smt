spec 3.14   A number as operand of `and` or `or` is a condition of its own: the comparison before it does not extend to it.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
U8  mode
bool on
[local]
F64 limit = 5 @read_only
[Hold]
.step
    mode == 1 or 2: -> Hold            #! W0419 did you mean 'mode == 2'?
    mode == 0 or 1: -> Hold            #! W0419 did you mean 'mode == 1'?
    x > 5 and 10: -> Hold              #! W0419 10 is a separate condition here and is always true
    on or x < 3 or 4.5: -> Hold        #! W0419 did you mean 'x < 4.5'?
    7 and on: -> Hold                  #! W0419 7
    on = x > 1 or (mode and 3)         #! W0419 3
    mode == not 5: -> Hold             #! W0419 did you mean 'mode != 5'?
    mode == not 1: -> Hold             # a switch
    mode == 1 or mode == 2: -> Hold
    on and true: -> Hold
    on and 0: -> Hold                  # a switch, as are the next two
    x > 5 or 1: -> Hold
    on or false: -> Hold
    on or limit: -> Hold
