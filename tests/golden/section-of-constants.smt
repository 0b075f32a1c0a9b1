# Constants in a section of their own, without types: one message, and none where they are used.
args check a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
[parameters]
limit = 3
[Run]
.step
    open = p > limit
-- stderr --
a.sm:7:1: error: this must follow a label of state 'parameters' [E0310]
    7 | limit = 3
      | ^~~~~ write .step on the line above it; a list of constants is [local], each with its type: F64 limit = 3
1 error
-- exit --
1
