# A statistic has an effect if a guard, an element or another statistic that matters needs it.
warn unused-window no-dead-code no-unused-local no-constant-guard no-unreachable-state
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 out
[local]
F64 avg = 0
F64 used = 0
F64 ring = 0
[Hold]
.step
    avg = roll_avg(p, 50)                     #! W0209 nothing depends
    used = roll_avg(p, 20)
    ring = ring + roll_range(p, 20)           #! W0209
    out = roll_max(roll_min(p, 3), 5)
    used > 5: -> Run
    p > 5: p < 4 {
        out = roll_median(p, 5)               #! W0209 never executed
    }
[Run]
[Never]
.step
    roll_min(p, 9) > 3: -> Hold               #! W0209 never executed
