spec 1.21   In a script, a statement of another language is reported once, at its first error.

-- app.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool v @read_only
[Idle]
.step
    v or p > 1: -> Vent
[Vent]
-- app.ss --
[all_states]
at 1 s: goto Vent                   #! E0383 write init_state Vent in [options]
at 1 s: go to Vent                  #! E0383 write init_state Vent in [options]
at 1 s: state := Vent               #! E0204 init_state in [options] sets the first one
at 1 s: print "hi"                  #! E0106 as in @print x "pressure"
at 1 s for 2 s: v = true            #! E0759 write from 1 s to 3 s
at 1 s for 500 ms: v = true         #! E0759 write from 1 s to ...
at 100 for 50.5: v = true           #! E0759 write from 100 to 150.5
after 1 s for 2 s: v = true         #! E0759 write from 1 s to 3 s
every 1 s for 10 s: v = true        #! E0759 write from 0 to 10 s { every 1 s: ... }
from 1 s for 2 s: v = true          #! E0760 write from 1 s to 3 s
from 1 s to 2 s for 3 s: v = true   #! E0759
at 1 s to 2 s: v = true             #! E0759 write from 1 s to 2 s
at 1 s until 2 s: v = true          #! E0759 write from 1 s to 2 s
at 1 s for 2 s, v = true            #! E0759 write from 1 s to 3 s
during 1 s to 2 s: v = true         #! E0329 write from 1 s to 2 s
v = true at 1 s                     #! E0380 write at 1 s: v = true
at 9 s: @stop
