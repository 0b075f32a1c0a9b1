spec 8.39   A guard by time has one time.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    p > 1: v = 1
-- app.ss --
[options]
delta_t 10 ms
[all_states]
at 1 s, 2 s: p = 3                    #! E0759 write G == 1 s or G == 2 s
at 1 s and 2 s: p = 3                 #! E0759 write G == 1 s or G == 2 s
at 1, 2 s: p = 3                      #! E0759 write G == 1 s or G == 2 s
at 1 s, at 2 s or at 3 s: p = 3       #! E0759 write G == 1 s or G == 2 s or G == 3 s
from 1 s to 2 s, 3 s to 4 s: p = 1    #! E0759 write 1 s <= G < 2 s or 3 s <= G < 4 s
every 1 s, 2 s: p = 1                 #! E0759 a guard of its own
at 5 s and p > 3: p = 2               #! E0759 write G == 5 s
at 9 s: @stop
