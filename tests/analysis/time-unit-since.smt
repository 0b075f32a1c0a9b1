# The time since a stored one, compared with a number that is probably in seconds.  Not with one that is a sum or another local, with a unit, or
# in steps.
warn no-all time-unit

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
bool go      @read_only
bool valve

[local]
U64  start   = 0
U64  last    = 0
U64  total   = 0

[define]
flight = G - start

[Wait]
.step
    go {
        start = G
        -> Open
    }

[Open]
.entry
    valve = true
    last = G + 100
.step
    G - start > 5: -> Shut                    #! W0420 'G - start' is compared with 5, and advances by 10 in each step
    flight >= 2.5: -> Shut                    #! W0420 is compared with 2.5, and is a whole number
    G - start > 5000: -> Shut
    G - start > 5 s: -> Shut
    G - start >= 1: valve = true
    G - last > 5: -> Shut
    G - total > 5: -> Shut
    T - total > 5: -> Shut

[Shut]
.entry
    valve = false
    total = total + 3
.step
    T > 3 s: -> Wait
