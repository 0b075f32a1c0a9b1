# A state that leaves in its first step for sure gives no time; one that waits, or may, does.
warn window-not-full no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool armed @read_only
[Init]
.entry
    armed: -> Check
    -> Idle
[Check]
.step
    roll_avg(p, 3) > 5: -> Idle           #! W0965 2 of 3
    T > 50: -> Late
[Idle]
.step
    -> Run
[Run]
.step
    roll_avg(p, 10) > 5: -> Late          #! W0965 of 10
    roll_avg(p, 3) < -5: -> Late
[Late]
.step
    roll_avg(p, 10) > 5: -> Init          #! W0965 of 10
