# A time with a unit that is less than half a step: it does not delay anything.  A time of half a step separates the first step from the others.
warn no-all time-unit

-- app.sm --
[options]
step 20 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
bool valve

[Open]
.entry
    valve = true
.step
    T > 3 ms: -> Hold                     #! W0420 'T' is compared with 3, and advances by 20 in each step

[Hold]
.step
    T > 10 ms: valve = false
    T > 3 s: -> Open
