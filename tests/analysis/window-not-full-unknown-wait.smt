# The same where it is not known.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[PowerOn]
.step
    T >= 500: -> Settle
[Settle]
.step
    T > 40: -> Calm
[Calm]
.step
    roll_avg(p, 59) > 5: -> Open
    roll_avg(p, 58) > 4: -> Open
    T >= 100: -> Late
[Open]
.step
    T > 20 and p > 3: -> Late
[Late]
.step
    roll_avg(p, 1000) > 5: -> PowerOn
