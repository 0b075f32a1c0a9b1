# Statistics of what the same step has assigned; what is meant to be old is left alone.
warn no-all late-sample

-- app.sm --
[state_vector]
U64  G
U32  S
F64  a        @read_only
F64  b        @read_only
bool valve
U8   duty
bool high
bool far
F64  shown
F64  order
F64  alone
[local]
F64  p     = 0
F64  q     = 0
F64  last  = 0
F64  start = 0
bool bad   = false
F64  arm   = 0
F64  twice = 0
[Watch]
.entry
    start = a
    p = 0
.step
    roll_avg(p, 5) > 7: valve = true        # before it is assigned
    p = max(a, b)
    roll_min(p, 2) > 28: -> Done            #! W0421 make 'p' a definition: p = max(a, b)
    min(p, roll_min(p, 1)) > 28: -> Done    # this step's value stands beside it
    roll_max(p, 3) - p > 5: -> Done
    b > roll_max(p, 3): -> Done             #! W0421 'p'
    q = q * 0.9 + p * 0.1
    shown = roll_max(q + 1, 3)              #! W0421 'q' is assigned here, after the sample
    shown = roll_avg(a - last, 4) + roll_avg(start, 3)
    last = a
    a > 30: bad = true
    else: bad = roll_avg(b, 4) > 30
    roll_min(bad, 3) > 0: -> Done           #! W0421 'bad'
    valve = roll_avg(roll_avg(p, 2), 3) > 5 #! W0421 'p'
    order = a * 2
    alone = a * 3
    roll_min(abs(order - b), 4) > 3: -> Done    # what came of the last order
    roll_min(alone, 4) > 3: -> Done             #! W0421 replace 'alone' by the expression itself: a * 3
    duty = a * 2
    roll_avg(duty, 5) > 300: -> Done        #! W0421
    high = a
    roll_avg(high, 5) > 0.5: -> Done        #! W0421
    far = a > 7
    roll_avg(far, 5) > 0.5: -> Done         #! W0421 replace 'far' by the expression itself: a > 7
    held(p > 1, 3 steps): -> Done           #! W0421 'held(p > 1, 3 steps)' does not include
    prev(p) > 1: -> Done                    #! W0421 'prev(p)' does not include
    rising(p > 1): -> Done                  #! W0421 'rising(p > 1)' does not include
    rate(p, 4) > 1: -> Done                 #! W0421 make 'p' a definition: p = max(a, b)
    p - prev(p) > 1: -> Done
    twice = a * 2
    rising(twice > 1): -> Done              #! W0421 replace 'twice' by the expression itself: a * 2
    a > 1 {
        arm = b
    }
    else {
        shown = roll_avg(arm, 7)            # the other arm has assigned nothing
    }
[Done]
.step
    twice = a * 3                           # so it cannot be a definition
    shown = roll_avg(p, 5)                  # only the other state assigns
