spec 5.40   A condition belongs before the braces, not in them.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    { x = 2 -> Abort }          #! E0320 write x == 2: -> Abort
    { x <= 2 and p - 1 > 2 -> Abort }   #! E0320 write x <= 2 and p - 1 > 2: -> Abort
    {x==3->Abort}               #! E0320 write x==3: ->Abort
    { -> Abort }                #! E0320
    { x = 1 }                   #! E0320
[Abort]
.step
    prev(S) == Hold: -> Hold    #! E0204 write prev(S == Hold)
    prev(S) != Hold or x > 2: -> Hold   #! E0204 write prev(S != Hold)
