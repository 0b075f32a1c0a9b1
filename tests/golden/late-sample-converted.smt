# What is stored is rounded or limited: the expression would not be the same.
args check -Wlate-sample a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 flow @read_only
U8  duty
F32 fine
bool vent
bool shut
[Run] @safe
.step
    duty = flow * 2
    vent = roll_avg(duty, 5) > 300
    fine = flow * 2
    shut = roll_avg(fine, 5) > 300
-- stderr --
a.sm:12:12: warning: this is never true: 'roll_avg(duty, 5)' is from 0 to 255, whatever the inputs are [W0418 decided-comparison]
   12 |     vent = roll_avg(duty, 5) > 300
      |            ^~~~~~~~~~~~~~~~~~~~~~~
a.sm:12:12: warning: 'roll_avg(duty, 5)' does not include the value that this step has assigned to 'duty' [W0421 late-sample]
   12 |     vent = roll_avg(duty, 5) > 300
      |            ^~~~~~~~~~~~~~~~~
a.sm:11:5: note: 'duty' is assigned here, after the sample of this step has been taken
a.sm:14:12: warning: 'roll_avg(fine, 5)' does not include the value that this step has assigned to 'fine' [W0421 late-sample]
   14 |     shut = roll_avg(fine, 5) > 300
      |            ^~~~~~~~~~~~~~~~~
a.sm:13:5: note: 'fine' is assigned here, after the sample of this step has been taken
3 warnings
