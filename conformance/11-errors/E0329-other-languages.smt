spec 1.13, 5.27   What engineers write who know MATLAB, Python, C or IEC 61131.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[local]
constant F64 lim = 4                #! E0329 write F64 lim = 4 @read_only
static F64 x = 5                    #! E0329 leave it out
[Hold]
.step
    else: -> Vent                   #! E0318 write the condition before it
    v++                             #! E0326 write v = v + 1
    self.valve = true               #! E0335 write valve
    p > math.e: -> Vent             #! E0335 write e
    tank.p > 3: -> Vent             #! E0335 write tank_p
    p > 5 for 3 s: -> Vent          #! E0315 write held(p > 5, 3 s)
    p > 5 for 3 samples: -> Vent    #! E0315 write held(p > 5, 3 steps)
    p > 5, valve: v = 1             #! E0315 write 'and' instead
    v = 0b101                       #! E0114 write 5
    @assert v > 1                   #! E0339 in a script (.ss)
    END_IF                          #! E0329 close braces
    end_case                        #! E0329 close braces
    end_for                         #! E0329 close braces
    end_while                       #! E0329 close braces
    endcase                         #! E0329 close braces
    continue                        #! E0329 into an 'else'
    pass                            #! E0329 leave it out
    break                           #! E0329 leave it out
    (* a remark *)                  #! E0110 begin the comment with #
    p > 6: -> Vent
[p > 5] -> Vent                     #! E0120 without brackets, as in p > 5: -> State
[Vent]
.entry
