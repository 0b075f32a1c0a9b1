# What other languages write gets one message each, and an edit only where it is certain.
args check app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hold @read_only
U8 mode
bool valve
[Hold]
mode = 1
.step
    p between 30 and 50: -> Vent
    wait(200)
    sleep 2.5
    mode = 1'000
    mode = 1 000
    p > 50°: -> Vent
    for (int i = 0; i < 3; i++) { mode = 1 }
    mode = 1; valve = false
    p > 50: valve = true, -> Vent
    int x = 3
    const F64 y = 3
    isnan(p): -> Vent
    p > 3
    and hold: -> Vent
    S = 2
    mode = wärme
    G == 5.005: -> Vent
[Vent]:
.step
    if hold
        mode = ~3
-- stderr --
app.sm:9:1: error: this must follow a label of state 'Hold' [E0310]
    9 | mode = 1
      | ^~~~ put it after a label: .entry is run once, .step in every step, .exit at the end
app.sm:11:5: error: a statement cannot begin with 'p' [E0328]
   11 |     p between 30 and 50: -> Vent
      |     ^ write 30 <= p <= 50
app.sm:12:5: error: 'wait' is not part of this language [E0329]
   12 |     wait(200)
      |     ^~~~ put what follows in braces, with the unit of the time: T >= 200 ms { ... }
app.sm:13:5: error: 'sleep' is not part of this language [E0329]
   13 |     sleep 2.5
      |     ^~~~~ put what follows in braces: T >= 2.5 s { ... }
app.sm:14:12: error: the number 1 is directly followed by ''000' [E0114]
   14 |     mode = 1'000
      |            ^~~~~ write 1000
app.sm:15:14: error: expected the end of the line, found the number 000 [E0330]
   15 |     mode = 1 000
      |              ^~~ write 1000
app.sm:16:11: error: the character '°' is allowed only in comments [E0102]
   16 |     p > 50°: -> Vent
      |           ^ write the number alone, in the unit of the element; sin, cos and tan take radians, which are degrees * 0.0174533
app.sm:17:5: error: 'for' is not part of this language [E0329]
   17 |     for (int i = 0; i < 3; i++) { mode = 1 }
      |     ^~~ there are no loops: .step runs again in every step
app.sm:18:13: error: a statement ends at the end of its line, without ';' [E0109]
   18 |     mode = 1; valve = false
      |             ^ put each statement on a line of its own
app.sm:19:25: error: expected the end of the line, found ',' [E0330]
   19 |     p > 50: valve = true, -> Vent
      |                         ^ put everything that depends on the condition in braces, each statement on a line of its own
app.sm:20:5: error: declare variables in the section [local] [E0338]
   20 |     int x = 3
      |     ^~~ write 'I32 x = 3' in [local], and 'x = 3' here
app.sm:21:5: error: declare variables in the section [local] [E0338]
   21 |     const F64 y = 3
      |     ^~~~~ write 'F64 y = 3 @read_only' in [local]
app.sm:22:5: error: unknown function 'isnan' [E0217]
   22 |     isnan(p): -> Vent
      |     ^~~~~ a stored value is never NaN: a sensor's NaN is read as 0; test the range of healthy values, as in not (0.5 < x < 60)
app.sm:23:5: error: this value has no effect [E0327]
   23 |     p > 3
      |     ^~~~~ a line may be continued only inside parentheses
app.sm:25:5: error: 'S' cannot be assigned: it holds the number of the state [E0215]
   25 |     S = 2
      |     ^ to go to the state 'Vent', write -> Vent
app.sm:26:13: error: the character 'ä' is allowed only in comments [E0102]
   26 |     mode = wärme
      |             ^ a name consists of a to z, A to Z, 0 to 9 and _
app.sm:28:7: error: this must follow a label of state 'Vent' [E0310]
   28 | [Vent]:
      |       ^ leave it out
app.sm:30:12: error: expected ':' or '{' after the condition, found the end of the line [E0315]
   30 |     if hold
      |            ^ insert '{', and write '}' below the statements that depend on it
app.sm:31:16: error: unknown operator '~' [E0108]
   31 |         mode = ~3
      |                ^ numbers have no bits here: keep each flag in a bool of its own
19 errors
-- exit --
1
