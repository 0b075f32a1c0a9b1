# Assignments that change nothing are taken away where they have a line to themselves, and constants are marked as such.
args fix app.sm
args check app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
F64 y
bool v
[local]
U16 a = (800)   # limit
F64 b = ((2 +
  3)   # hm )
  ) @allow(unused-local, "not true")
F64 c = a + b
[Hold]
.entry
    x = x
    y = 1
    y = 2   # two
.step
    p > a: y = y
    p > b {
        v = v
    }
    p > c {
        v = v   # why
        x = 1
        @allow(not-precedence, "it is meant")
        x = not v + 2
    }
    @allow(dead-code, "x")
    x = x
    x = 5
-- file app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
F64 y
bool v
[local]
U16 a = (800) @read_only   # limit
F64 b = ((2 +
  3)   # hm )
  ) @read_only
F64 c = a + b @read_only
[Hold]
.entry
    y = 2   # two
.step
    p > a: y = y
    p > b {
        v = v
    }
    p > c {
        # why
        @allow(not-precedence, "it is meant")
        x = not v + 2
    }
    x = 5
-- stdout --
app.sm:9:
  - U16 a = (800)   # limit
  + U16 a = (800) @read_only   # limit
app.sm:12:
  -   ) @allow(unused-local, "not true")
  - F64 c = a + b
  +   ) @read_only
  + F64 c = a + b @read_only
app.sm:16:
  -     x = x
  -     y = 1
app.sm:25:
  -         v = v   # why
  -         x = 1
  +         # why
app.sm:30:
  -     @allow(dead-code, "x")
  -     x = x
app.sm: 10 fixed
-- stderr --
app.sm:18:12: warning: 'y' is assigned to itself [W0412 self-assignment]
   18 |     p > a: y = y
      |            ^~~~~
app.sm:20:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   20 |         v = v
      |         ^~~~~
app.sm:25:9: warning: what is stored in 'x' here is overwritten before anything reads it [W0410 dead-store]
   25 |         x = not v + 2
      |         ^~~~~~~~~~~~~
app.sm:27:5: note: it is overwritten here
3 warnings
app.sm:18:12: warning: 'y' is assigned to itself [W0412 self-assignment]
   18 |     p > a: y = y
      |            ^~~~~
app.sm:20:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   20 |         v = v
      |         ^~~~~
app.sm:25:9: warning: what is stored in 'x' here is overwritten before anything reads it [W0410 dead-store]
   25 |         x = not v + 2
      |         ^~~~~~~~~~~~~
app.sm:27:5: note: it is overwritten here
3 warnings
