# late-sample proposes to sample the assigned expression only if the variable stores its value as it is, and in each step.
args check -Wno-dead-store -Wno-constant-range -Wlate-sample a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 a @read_only
U8  duty
U8  ticks
F64 held_back
F64 out
F64 all
[Run]
.step
    duty = a * 2
    out = roll_avg(duty, 5)
    ticks = T
    out = out + roll_avg(ticks, 5)
    a > 3: held_back = a * 3
    out = out + roll_avg(held_back, 5)
    all = a * 4
    out = out + roll_avg(all, 5)
-- stderr --
a.sm:13:11: warning: 'roll_avg(duty, 5)' does not include the value that this step has assigned to 'duty' [W0421 late-sample]
   13 |     out = roll_avg(duty, 5)
      |           ^~~~~~~~~~~~~~~~~
a.sm:12:5: note: 'duty' is assigned here, after the sample of this step has been taken
a.sm:15:17: warning: 'roll_avg(ticks, 5)' does not include the value that this step has assigned to 'ticks' [W0421 late-sample]
   15 |     out = out + roll_avg(ticks, 5)
      |                 ^~~~~~~~~~~~~~~~~~
a.sm:14:5: note: 'ticks' is assigned here, after the sample of this step has been taken
a.sm:17:17: warning: 'roll_avg(held_back, 5)' does not include the value that this step has assigned to 'held_back' [W0421 late-sample]
   17 |     out = out + roll_avg(held_back, 5)
      |                 ^~~~~~~~~~~~~~~~~~~~~~
a.sm:16:12: note: 'held_back' is assigned here, after the sample of this step has been taken
a.sm:19:17: warning: 'roll_avg(all, 5)' does not include the value that this step has assigned to 'all' [W0421 late-sample]
   19 |     out = out + roll_avg(all, 5)
      |                 ^~~~~~~~~~~~~~~~
a.sm:18:5: note: 'all' is assigned here, after the sample of this step has been taken
note: replace 'all' by the expression itself: a * 4
4 warnings
