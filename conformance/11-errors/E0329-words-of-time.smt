spec 8.39, 8.43   Other words before a time are answered with those of this language.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p
-- app.ss --
[options]
delta_t 10
[all_states]
until 5 s: p = 1            #! E0329 write from 0 to 5 s
before 5 s: p = 1           #! E0329 write from 0 to 5 s
between 5 s and 6 s: p = 1  #! E0329 write from 5 s to 6 s
since 5 s: p = 1            #! E0329 write after 5 s
each 5 s: p = 1             #! E0329 write every 5 s
on 5 s: p = 1               #! E0329 write at 5 s
when 5 s: p = 1             #! E0329 write at 5 s
while 5 s: p = 1            #! E0329 write from 0 to 5 s
at 1 s: @stop
