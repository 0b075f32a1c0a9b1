spec 1.31, 3.2   After an operator a value must follow on the line, outside parentheses.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    p >: -> Hold        #! E0312 expected a value after '>', found ':'
    x = (p +
         1)
    x = p +             #! E0312 found the end of the line
    x =                 #! E0312 after '='
    x = * p             #! E0312 after '='
    x = abs(,)          #! E0312 after '('
    x = max(p, )        #! E0312 after ','
    x = ()              #! E0312 after '('
    x = not             #! E0312 after 'not'
    if if p > 1: x = 1  #! E0312 leave it out
    x = [1, 2]          #! E0312 there are no lists
    x = [p]             #! E0312 there are no lists
    x =                 #! E0312 found the end of the line
[Next]
    p > 5 and < 6: x = 1 #! E0312 repeat what is compared before
