spec 1.21   An operator spelled as in other languages is named as it is spelled here.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p > 1 && x > 1: x = 1       #! E0107 write and
    p > 1 || x > 1: x = 1       #! E0107 write or
    p === 1: x = 1              #! E0107 write ==
    p !== 1: x = 1              #! E0107 write !=
    p <> 1: x = 1               #! E0107 write !=
    p ~= 1: x = 1               #! E0107 write !=
    ~p: x = 1                   #! E0107 write not
    p => 1: x = 1               #! E0107 write >=
    p =< 1: x = 1               #! E0107 write <=
    x := 1                      #! E0107 write =
    p > 1: => Hold              #! E0107 write ->
