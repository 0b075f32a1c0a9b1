# The edits of all rounds are applied to the file.  Mistakes without a certain edit are left and reported.
args fix app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step:
    IF x > 5 && x < 7 THEN -> Hold;
    if x = 5: { x = 1,5 }
    x = max(x; 1)   // larger
    x == 3
-- file app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
.step
    if x > 5 and x < 7: -> Hold
    if x == 5 { x = 1.5 }
    x = max(x, 1)   # larger
    x == 3
-- stdout --
app.sm:6:
  - .step:
  -     IF x > 5 && x < 7 THEN -> Hold;
  -     if x = 5: { x = 1,5 }
  -     x = max(x; 1)   // larger
  + .step
  +     if x > 5 and x < 7: -> Hold
  +     if x == 5 { x = 1.5 }
  +     x = max(x, 1)   # larger
app.sm: 10 fixed
-- stderr --
app.sm:10:5: error: this value has no effect [E0327]
   10 |     x == 3
      |     ^~~~~~ to store, write x = 3; a condition needs ':' or '{' after it
1 error
-- exit --
1
