# Where it is known how far time advances in a step, a state that is left at a T gives so many steps, 500 are 50 of 10; one that may be
# left otherwise, or is not for sure left then, gives time.
warn window-not-full no-dead-store
advance 10
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
    roll_avg(p, 59) > 5: -> Open          #! W0965 58 of 59
    roll_avg(p, 58) < -4: -> Open
    T >= 100: -> Late
[Open]
.step
    T > 20 and p > 3: -> Late
[Late]
.step
    roll_avg(p, 1000) > 5: -> PowerOn     #! W0965 of 1000
