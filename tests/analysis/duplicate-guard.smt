spec 5.35   One guard twice, in a chain of else if or in a row of transitions.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool ready
[local]
F64 x = 0
[Chain]
.step
    if p > q: x = 1
    else if q > 5: x = 2
    else if p > q: x = 3                 #! W0507
    if p > q + 9: x = 5
    else if p > 50: x = 6
    else if q > 3: x = 7
    else if p > 50: x = 8                #! W0507
    if p > 3: x = x + 1
    else if p > 3: -> Row                #! W0507
    ready: -> Row
[Row]
.step
    ready and p > q: -> Chain
    x > 5: -> Chain
    ready and p > q: -> Row              #! W0507
    x > 2: -> Twice
    not ready: -> Chain
    p > 1: -> Chain
    not ready: x = 0                     #! W0507
[Twice]
.step
    ready: x = 1
    ready: -> Chain                      # both are executed
    p > 4: -> Row
    p = q
    p > 4: -> Row                        # another p
    x > 4: -> Row
    q > 2: x = q
    x > 4: -> Chain
