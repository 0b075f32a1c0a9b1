# Of many transitions the last three are shown; the machine is in the state that its last step chose.
args test a.sm a.ss --max-steps=8
args test a.sm a.ss --max-steps=9

-- a.sm --
[state_vector]
U64 G
U32 S
U8 n
[One]
.step
    n = n + 1
    n > 1: -> Two
[Two]
.step
    n > 2: -> Three
    n = n + 1
[Three]
.exit
    n = 0
.step
    -> One
-- a.ss --
[options]
delta_t 10
[all_states]
true: @assert n < 9
[Three]
T == 10: @stop
-- stderr --
a.ss:6:10: error: the script did not reach @stop within 8 steps [E0751]
    6 | T == 10: @stop
      |          ^~~~~
a.ss:6:10: note: section [Three] last ran in step 5 (G = 40), and this condition was never true in it
note: the machine has been in state 'Two' since step 8 (G = 70)
note: the last steps, and the values after each:
      step   G  state   T
         4  30  Two    10
         5  40  Three   0
         6  50  One     0
         7  60  One    10
         8  70  Two     0
a.sm:11:12: note: transition in step 4 (G = 30): Two -> Three
a.sm:17:5: note: transition in step 5 (G = 40): Three -> One
a.sm:8:12: note: transition in step 7 (G = 60): One -> Two
1 error
a.ss:6:10: error: the script did not reach @stop within 9 steps [E0751]
    6 | T == 10: @stop
      |          ^~~~~
a.ss:6:10: note: section [Three] last ran in step 5 (G = 40), and this condition was never true in it
note: the machine has been in state 'Three' since step 10 (G = 90)
note: the last steps, and the values after each:
      step   G  state   T
         5  40  Three   0
         6  50  One     0
         7  60  One    10
         8  70  Two     0
         9  80  Two    10
a.sm:17:5: note: transition in step 5 (G = 40): Three -> One
a.sm:8:12: note: transition in step 7 (G = 60): One -> Two
a.sm:11:12: note: transition in step 9 (G = 80): Two -> Three
1 error
-- exit --
1 1
