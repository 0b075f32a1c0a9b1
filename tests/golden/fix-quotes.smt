# Quotation marks around a name go; a text after a complete statement becomes a comment.
args fix app.sm app.ss

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p "tank pressure" @read_only
F64 q "bar"
U8 code
[Idle]
.step
    “p” > 5: code = 1, "too high"
    p > 7: -> Abort "too high"
    code = max("p", 1)
[Abort]
-- app.ss --
[options]
init_state "Idle"
delta_t 10 "ms"
[all_states]
G == 0: @assert p > 5, "too low"
G == 10: @assert p > 5 “too low”
G == 20: @assert(p > 5, "too low")
G == 30: @assert p > "abc"
G > 50: @stop
-- stdout --
app.sm:5:
  - F64 q "bar"
  + F64 q  # bar
app.sm:9:
  -     “p” > 5: code = 1, "too high"
  -     p > 7: -> Abort "too high"
  -     code = max("p", 1)
  +     p > 5: code = 1  # too high
  +     p > 7: -> Abort  # too high
  +     code = max(p, 1)
app.sm: 5 fixed
app.ss:2:
  - init_state "Idle"
  - delta_t 10 "ms"
  + init_state Idle
  + delta_t 10  # ms
app.ss:5:
  - G == 0: @assert p > 5, "too low"
  - G == 10: @assert p > 5 “too low”
  + G == 0: @assert p > 5 "too low"
  + G == 10: @assert p > 5 "too low"
app.ss: 4 fixed
-- stderr --
app.sm:4:7: error: quoted text is not allowed here [E0106]
    4 | F64 p "tank pressure" @read_only
      |       ^~~~~~~~~~~~~~~ write names and conditions without quotation marks, and remarks after #
app.ss:7:25: error: quoted text is not allowed here [E0106]
    7 | G == 20: @assert(p > 5, "too low")
      |                         ^~~~~~~~~ write it as a comment, after # at the end of the line
app.ss:8:22: error: quoted text is not allowed here [E0106]
    8 | G == 30: @assert p > "abc"
      |                      ^~~~~ write abc if it is a name; a value is a number, true or false
3 errors
-- exit --
1
