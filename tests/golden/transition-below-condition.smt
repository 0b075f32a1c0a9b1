# A condition without ':' above a transition: no warning about the statements after the transition.
args check a.sm
args check b.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[A]
.step
    x > 90
        -> Idle
    y = 2
[Idle] @safe
.step
    y = 3
-- b.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y
[A]
.step
    x > 90
    -> Idle
    y = 2
[Idle] @safe
.step
    y = 3
-- stderr --
a.sm:8:5: error: this value has no effect [E0327]
    8 |     x > 90
      |     ^~~~~~ a condition needs ':' and a statement after it, or statements in '{' and '}'
1 error
b.sm:8:5: error: this value has no effect [E0327]
    8 |     x > 90
      |     ^~~~~~ a condition needs ':' and a statement after it, or statements in '{' and '}'
1 error
-- exit --
1 1
