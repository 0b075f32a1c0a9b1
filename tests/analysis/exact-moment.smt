# T, G and what is reckoned from them, against a moment that is not the beginning.
warn exact-moment no-dead-store no-constant-guard no-read-before-write no-duplicate-guard no-shadowed-transition
-- app.sm --
[state_vector]
U64 time @alias G
U32 S
F64 p @read_only
U32 phase @read_only
F64 burn @read_only
U8 x
[local]
U64 start = 0
U64 now = 0
U64 due = 0
U32 elapsed = 0
U32 ticks = 0
F64 half = 0
U64 wait = 500 @read_only
[Hold]
.entry
    start = G
    due = G + 500
.step
    now = time
    elapsed = G - start
    ticks = T / 10
    half = p
    T == 15: x = 1            #! W0408 'T' is possibly never exactly 15
    T != 15: x = 2            #! W0408
    15 == time: x = 3         #! W0408 'time'
    T - 5 == 10: x = 4        #! W0408 'T - 5'
    T * 2 == 10: x = 5        #! W0408
    T / 1000 == 5: x = 5      #! W0408
    G - start == 100: x = 6   #! W0408 'G - start'
    G == due: x = 7           #! W0408 exactly due
    now == 5000: x = 8        #! W0408 'now'
    now - start == 10: x = 9  #! W0408
    elapsed == 100: x = 10    #! W0408 'elapsed'
    T == burn: x = 11         #! W0408 exactly burn
    T == wait: x = 12         #! W0408 exactly 500
    T == start + 10: x = 1    #! W0408
    T == 0: x = 13
    T * 2 == 0: x = 14
    G == start: x = 15
    G - start == 0: x = 16
    elapsed == 0: x = 17
    due == 0: x = 18
    ticks == 5: x = 19
    floor(T / 1000) == 5: x = 20
    T >= 15: x = 21
    S == 2: x = 22
    phase == 3: x = 23
    half == 3: x = 24
    start == 0: start = G
