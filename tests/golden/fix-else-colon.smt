# The = after the colon of an else belongs to no condition: nothing is changed.
args fix app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
U8 mode
U8 level @read_only
[Run] @safe
.step
    level: mode = 1
    else: = 2
-- stderr --
app.sm:9:11: error: expected a statement, found '=' [E0341]
    9 |     else: = 2
      |           ^
1 error
-- exit --
1
