spec 8.82   Recorded data needs a unit of time.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 100 us
[flight]
every 10 ms:
    machine main "steady.sm"
-- d.csv --
t,GO
0,0
-- flight.ss --
[data]               #! E0798 [data]
file "d.csv"
time "t" ms
go = "GO"
[all_states]
true: @assert not go
at 100: @stop
-- rocket.sv --
[A]
U64  time
U32  state
bool go
bool fire
-- steady.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
bool go    @read_only
bool fire

[Run] @safe
.step
    fire = go
