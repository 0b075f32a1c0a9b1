# Syntax of other languages is fixed where the meaning is certain, and stays as it is elsewhere.
args fix app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool hold @read_only
U8 mode
U8 secs
bool valve
[Hold]
.step
    valve = True
    if if p > 5: valve = false
    p > 3,5 and T > 2,5: -> "Vent"
    hold: –> Vent
    mode = 2   // open
    valve = true // open the valve
[Vent]
.step
    secs = T // 1000
    secs = T // mode
    (p // 2
        > 50): -> Hold
    mode =! 3: -> Hold
    (mode & 4) == 4: -> Hold
    valve = NaN
-- stdout --
app.sm:11:
  -     valve = True
  -     if if p > 5: valve = false
  -     p > 3,5 and T > 2,5: -> "Vent"
  -     hold: –> Vent
  -     mode = 2   // open
  -     valve = true // open the valve
  +     valve = true
  +     if p > 5: valve = false
  +     p > 3.5 and T > 2.5: -> Vent
  +     hold: -> Vent
  +     mode = 2   # open
  +     valve = true # open the valve
app.sm: 8 fixed
-- stderr --
app.sm:19:14: error: unknown operator '//' [E0108]
   19 |     secs = T // 1000
      |              ^~ to divide and round down, write floor(a / b); a comment begins with #
app.sm:20:14: error: a comment begins with '#', not with '//' [E0110]
   20 |     secs = T // mode
      |              ^~ begin the comment with #; to divide and round down, write floor(a / b)
app.sm:21:8: error: unknown operator '//' [E0108]
   21 |     (p // 2
      |        ^~ to divide and round down, write floor(a / b); a comment begins with #
app.sm:23:10: error: unknown operator '=!' [E0108]
   23 |     mode =! 3: -> Hold
      |          ^~ did you mean '!='?
app.sm:24:11: error: unknown operator '&' [E0108]
   24 |     (mode & 4) == 4: -> Hold
      |           ^ numbers have no bits here: keep each flag in a bool of its own
app.sm:25:13: error: unknown element 'NaN' [E0204]
   25 |     valve = NaN
      |             ^~~ a stored value is never NaN: a sensor's NaN is read as 0; test the range of healthy values, as in not (0.5 < x < 60)
6 errors
-- exit --
1
