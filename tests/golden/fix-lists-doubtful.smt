# Lists that can mean ranges, states or another unit: smc fix changes nothing.
args fix app.sm app.ss

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only @range 0,5
bool valve
I32 v
[Hold]
.step
    v in (1, 5): -> Vent
    v + 1 in (1, 5): -> Vent
    valve in Vent: v = 1
    v in range(5): -> Vent
    v == 7: -> Vent(2)
[Vent]
.entry
-- app.ss --
[options]
delta_t 10 ms
[all_states]
at 1, 2 s: p = 3
every 1 s, 2 s: p = 1
at 9 s: @stop
-- stderr --
app.sm:4:26: error: expected a number, the highest value of '@range', found ',' [E0377]
    4 | F64 p @read_only @range 0,5
      |                          ^ write two numbers, as in @range 0 40
app.sm:9:7: error: 'in' is not part of this language [E0329]
    9 |     v in (1, 5): -> Vent
      |       ^~ write v == 1 or v == 5; for a range of values, 1 <= v <= 5
app.sm:10:11: error: 'in' is not part of this language [E0329]
   10 |     v + 1 in (1, 5): -> Vent
      |           ^~ compare with each value, as in x == a or x == b
app.sm:11:11: error: 'in' is not part of this language [E0329]
   11 |     valve in Vent: v = 1
      |           ^~ write valve and S == Vent if a state is meant, valve == Vent if a value is
app.sm:12:7: error: 'in' is not part of this language [E0329]
   12 |     v in range(5): -> Vent
      |       ^~ compare with each value, as in v == a or v == b
app.sm:13:20: error: expected the end of the line, found '(' [E0330]
   13 |     v == 7: -> Vent(2)
      |                    ^ a state takes no arguments: write -> Vent, and store the value in an element or a local before it
app.ss:4:1: error: 'at 1' is a whole condition and cannot be part of another one [E0759]
    4 | at 1, 2 s: p = 3
      | ^~~~ write G == 1 s or G == 2 s
app.ss:5:1: error: 'every 1 s' is a whole condition and cannot be part of another one [E0759]
    5 | every 1 s, 2 s: p = 1
      | ^~~~~~~~~ write each time as a guard of its own: every 1 s: ...
8 errors
-- exit --
1
