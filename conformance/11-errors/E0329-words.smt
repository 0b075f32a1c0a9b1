spec 1.11   Words that begin a statement in other languages.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
bool b
[Hold]
.step
    IF p > 5: x = 1                 #! E0329 write if
    when p > 5: x = 1               #! E0329 write if
    elif p > 5: x = 1               #! E0329 write else if
    elseif p > 5: x = 1             #! E0329 write else if
    elsif p > 5: x = 1              #! E0329 write else if
    iff p > 5: x = 1                #! E0329 write if
    ELSE if p > 5: x = 1            #! E0329 write else
    otherwise if p > 5: x = 1       #! E0329 write else
    p > 5: goto Hold                #! E0329 write ->
    p > 5: go Hold                  #! E0329 write ->
    p > 5: transition Hold          #! E0329 write ->
    let x = 3                       #! E0329 leave it out
    set x = 3                       #! E0329 leave it out
    var x = 3                       #! E0329 leave it out
    const x = 3                     #! E0329 leave it out
    while p                         #! E0329 there are no loops: write 'if'
    for p                           #! E0329 there are no loops: .step runs
    repeat p                        #! E0329 there are no loops: .step runs
    loop p                          #! E0329 there are no loops: .step runs
    until p                         #! E0329 there are no loops: write 'if 
    unless p                        #! E0329 write the opposite condition: 
    case p                          #! E0329 write it as if p == 1 ... else
    switch p                        #! E0329 write it as if p == 1 ... else
    case p
    return p                        #! E0329 there are no functions to return from
    break                           #! E0329 leave it out: there are no loops
    wait 200                        #! E0329 T >= 200
    delay 200                       #! E0329 T >= 200
    sleep 200                       #! E0329 T >= 200
    end                             #! E0329 close braces with }
    endif                           #! E0329 close braces with }
    assert p                        #! E0329 write @assert in a script
    verify p                        #! E0329 write @assert in a script
    stop                            #! E0329 write @stop
