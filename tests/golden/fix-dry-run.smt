# What would be edited is shown and no file changed; the exit code is that of the edits made.
args fix --dry-run app.sm
args fix --dry-run wrong.sm
args fix wrong.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    if x = 5: { x = 1,5 }
-- wrong.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step:
    x == 3
-- file app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    if x = 5: { x = 1,5 }
-- file wrong.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    x == 3
-- stdout --
app.sm:7:
  -     if x = 5: { x = 1,5 }
  +     if x == 5 { x = 1.5 }
app.sm: 3 to fix
wrong.sm:6:
  - .step:
  + .step
wrong.sm: 1 to fix
wrong.sm:6:
  - .step:
  + .step
wrong.sm: 1 fixed
-- stderr --
wrong.sm:7:5: error: this value has no effect [E0327]
    7 |     x == 3
      |     ^~~~~~ to store, write x = 3; a condition needs ':' or '{' after it
1 error
wrong.sm:7:5: error: this value has no effect [E0327]
    7 |     x == 3
      |     ^~~~~~ to store, write x = 3; a condition needs ':' or '{' after it
1 error
-- exit --
0 1 1
