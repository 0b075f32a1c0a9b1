# Constants are marked as such. Assignments that change nothing are left to who knows what was meant.
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
    x = x
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
app.sm:30:
  -     @allow(dead-code, "x")
app.sm: 5 fixed
-- stderr --
app.sm:16:5: warning: 'x' is assigned to itself [W0412 self-assignment]
   16 |     x = x
      |     ^~~~~
app.sm:17:5: warning: the value assigned to 'y' is overwritten before it is read [W0410 dead-store]
   17 |     y = 1
      |     ^~~~~
app.sm:18:5: note: it is overwritten here
app.sm:20:12: warning: 'y' is assigned to itself [W0412 self-assignment]
   20 |     p > a: y = y
      |            ^~~~~
app.sm:22:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   22 |         v = v
      |         ^~~~~
app.sm:25:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   25 |         v = v   # why
      |         ^~~~~
app.sm:26:9: warning: the value assigned to 'x' is overwritten before it is read [W0410 dead-store]
   26 |         x = 1
      |         ^~~~~
app.sm:28:9: note: it is overwritten here
app.sm:30:5: warning: 'x' is assigned to itself [W0412 self-assignment]
   30 |     x = x
      |     ^~~~~
7 warnings
app.sm:16:5: warning: 'x' is assigned to itself [W0412 self-assignment]
   16 |     x = x
      |     ^~~~~
app.sm:17:5: warning: the value assigned to 'y' is overwritten before it is read [W0410 dead-store]
   17 |     y = 1
      |     ^~~~~
app.sm:18:5: note: it is overwritten here
app.sm:20:12: warning: 'y' is assigned to itself [W0412 self-assignment]
   20 |     p > a: y = y
      |            ^~~~~
app.sm:22:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   22 |         v = v
      |         ^~~~~
app.sm:25:9: warning: 'v' is assigned to itself [W0412 self-assignment]
   25 |         v = v   # why
      |         ^~~~~
app.sm:26:9: warning: the value assigned to 'x' is overwritten before it is read [W0410 dead-store]
   26 |         x = 1
      |         ^~~~~
app.sm:28:9: note: it is overwritten here
app.sm:30:5: warning: 'x' is assigned to itself [W0412 self-assignment]
   30 |     x = x
      |     ^~~~~
7 warnings
