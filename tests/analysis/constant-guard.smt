spec 5.30   Guards that are always or never true, where no other warning gives the reason.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool valve
U8 level
[local]
U8 mode = 0
[A]
.step
    p > 20 and p < 10: valve = true      #! W0510 exclude each other
    20 < p < 10: valve = false           #! W0510
    p > q and p < q: valve = true        #! W0510
    p != q and p == q: valve = true      #! W0510
    p == q and p != q: valve = true      #! W0510
    valve and not valve: valve = true    #! W0510
    p > p: valve = true                  #! W0508
    p > 10 or p < 20: valve = false      #! W0511 cover every case
    p > q or p <= q: valve = true        #! W0511
    p > 5 {
        p > 3: valve = false             #! W0509 here 'p' is always above 5
        p < 4: valve = true              #! W0508
    }
    else if p > 6: valve = false         #! W0508 whenever it would be true, this earlier one has been true
    mode = 5
    mode > 10: valve = true              #! W0508 here 'mode' is always 5
    p > q {
        p > q: valve = true              #! W0509
    }
    abs(p) < 0: valve = false            #! W0508
    level * 2 > 600: valve = false       #! W0418
    q > 9: -> B
    q < 12: valve = true                 #! W0509
[B]
.entry
    T == 0: valve = true                 #! W0509
