spec 8.41  A guard by time cannot be part of an expression.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
at 20 and p == 0: p = 1           #! E0759 write G == 20
from 20 to 40 or p == 1: p = 1    #! E0759 write 20 <= G < 40
after 5 s and p > 0: p = 1        #! E0759 write G >= 5 s
every 20 and p > 0: p = 1         #! E0759 put the other condition inside: every 20 { ... }
p == 0 and at 20: p = 1           #! E0759 write G == 20
not after 20: p = 1               #! E0759 write G >= 20
p == 0 and from 20 to 30: p = 1   #! E0759 write 20 <= G < 30
p == 0 or every 20: p = 1         #! E0759 put the other condition inside
at 20 + 10: p = 1                 #! E0759 write G == 20
at 5 to 6: p = 1                  #! E0759 write from 5 to 6
after 5 s to 6 s: p = 1           #! E0759 write from 5 s to 6
at 100: @stop
