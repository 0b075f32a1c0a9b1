spec 8.40, 8.43  Something else than a number after the word is an error.

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
at T + 5: p = 1        #! E0761 write T == 5 s for the time since the state began, or at 5 s
after T+5: p = 1       #! E0761 write T >= 5 s
at burnout: p = 1      #! E0761 write G == burnout
at G == 5: p = 1       #! E0761 write at 5
from p to 6: p = 1     #! E0761 write from 5 s to 6 s
every p: p = 1         #! E0761 write every 5 s
from 5: p = 1          #! E0760 write after 5
from 5 until 6: p = 1  #! E0760 write to
from 5 and 6: p = 1    #! E0760 found 'and'
from 5 to x: p = 1     #! E0760 found 'to'
at 5s: p = 1           #! E0114 did you mean '5 s'?
at 100: @stop
