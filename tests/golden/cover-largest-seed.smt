# The largest seed is 2^53, as for scripts.
args cover --seed=9007199254740992 --effort=1 app.sm -o out >list.txt && echo accepted
args cover --seed=9007199254740993 --effort=1 app.sm -o out

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
[A]
.step
    p > 1: -> B
[B] @safe
-- stdout --
accepted
-- stderr --
smc: --seed requires a whole number from 0 to 9007199254740992, not '9007199254740993'
Try 'smc cover --help'.
-- exit --
0 2
