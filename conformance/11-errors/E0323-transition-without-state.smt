spec 5.29   -> needs the name of a state.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 5: ->           #! E0323 end of the line
    p > 6: -> 3         #! E0323 the number 3
    p > 7: -> if        #! E0323 'if'
