spec 1.16   A unit must be converted, not omitted: the message gives the converted number.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[Hold]
.step
    T > 5s: x = 1           #! E0114 write 5000 if 'G' counts milliseconds
    T > 2.5s: x = 1         #! E0114 write 2500 if
    T > 0.0005 s: x = 1     #! E0330 write 0.5 if
    T > 1_500ms: x = 1      #! E0114 write 1500 if
    T > 20 us: x = 1        #! E0330 write 0.02 if
    T > 2 min { x = 1 }     #! E0330 write 120000 if
    T > 1.5h: x = 1         #! E0114 write 5400000 if
    T > 1e30 s: x = 1       #! E0330 convert 1e30 s to the unit
    p > 5 bar: x = 1        #! E0330 convert 5 bar to the unit
    x = 5psi                #! E0114 convert 5 psi to the unit
    x = 2p                  #! E0114 write 2 * p to multiply
