spec 8.64, 8.66, 8.72   Ticks with the same G have the same row: it is written, and compared, in each of them.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 500 us:
    task sensor
every 2 ms:
    machine main "echo.sm"
-- d.csv --
t,P,ECHO
0,1,1
1,2,1
2,3,3
3,4,3
4,5,5
-- flight.ss --
[local]
U32 ticks = 0
F64 sum = 0

[data]
file "d.csv"
time "t" ms
p = "P"
@compare echo "ECHO"

[all_states]
true {
    ticks = ticks + 1
    sum = sum + p
}
ticks == 4: p = 100             # only in this tick: the data is written again in the next
at 1: @assert p == 2 or p == 100
at 2: @assert p == 3
every 2 ms: @assert echo == p
at 3: @assert sum == 2 * (1 + 2 + 3 + 4) or ticks == 7
ticks == 8: @assert G == 3 and p == 4
ticks == 10: @assert G == 4 and sum == 2 * (1 + 2 + 3 + 4 + 5)
ticks == 10: @stop
-- rocket.sv --
[A]
U64  time
U32  state
F64  p
F64  echo
-- echo.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only
F64  echo

[Run] @safe
.step
    echo = p
