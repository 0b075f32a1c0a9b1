# Statistics that decide in a state's first step, when fewer steps have run for sure than their window holds.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only
F64 mean
F64 shown
[local]
F64 local = 0
U32 steps = 0
U64 begun = 0
U64 since = 0
[First]
.entry
    begun = G
    roll_avg(p, 10) > 5: -> Wait          #! W0965 'roll_avg(p, 10)' is full: it has 1 of 10 samples
.step
    since = G - begun
    steps = steps + 1
    mean = roll_avg(p, 20)
    local = roll_median(p, 3) * 2
    armed and roll_avg(p, 2) > 1: -> Wait         #! W0965 it has 1 of 2
    mean > 5 and armed: -> Wait                   #! W0965 'mean' is full: it has 1 of 20
    local < 3: -> Wait                            #! W0965 'local' is full: it has 1 of 3 
    roll_max(p, 5) < 3: -> Wait                   #! W0965 1 of 5
    not (roll_max(p, 5) >= 3): -> Wait            #! W0965
    armed {
        roll_range(p, 5) < 1: -> Wait             #! W0965
    }
    roll_max(p, 5) > 30: -> Wait
    not (roll_min(p, 5) > 1): -> Wait
    roll_range(p, 5) > 3: -> Wait
    roll_avg(p, 1) > 5: -> Wait
    T > 500 and roll_avg(p, 10) > 5: -> Wait
    G > 500 and roll_avg(p, 10) > 5: -> Wait
    since > 500 and roll_avg(p, 10) > 5: -> Wait
    steps > 10 and roll_avg(p, 10) > 5: -> Wait
    T > 500 {
        roll_avg(p, 10) > 9: -> Wait
    }
    roll_avg(p, 10) > 9: shown = 0
[Wait]
.step
    roll_avg(p, 10) > 5: -> First
    local = roll_median(p, 30)                    # what counts in [First] is its own
