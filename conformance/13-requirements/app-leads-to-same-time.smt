spec 13.12, 13.22  Several ticks can have the same G: the last of them that is in time decides.
expect fail

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms

[fast]
every 1 ms:
    machine one "one.sm"

[slow]                 #! W0790
every 1500 us:
    machine two "two.sm"
-- flight.rq --
R1 "in the second tick of 13 ms" always fire leads to go within 2 ms
R2 "in no tick of 12 ms"         always fire leads to go within 1 ms     #! E1310 in step 26
R3 "met at once"                 always fire leads to p == 10 within 0
-- flight.ss --
[all_states]
G == 10: p = 10
G == 20: @stop
-- rocket.sv --
[options]
lock
[A]
U64  time
U32  oneState
U32  twoState
F64  p
bool fire
bool go
-- one.sm --
[state_vector]
U64  time     @alias G
U32  oneState @alias S
F64  p        @read_only
bool fire

[Idle] @safe
.step
    fire = false
    p > 5: -> Fire

[Fire] @safe
.entry
    fire = true
-- two.sm --
[state_vector]
U64  time     @alias G
U32  twoState @alias S
bool fire     @read_only
bool go

[Wait] @safe
.step
    go = false
    fire: -> Go

[Go] @safe
.entry
    go = true
