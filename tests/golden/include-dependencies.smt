# The rule of smc report lists included files once; a script that another one includes does not run by itself.
args report a.sm a.ss b.ss -o a.html -MD

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- b.ss --
include "c.ss"
[Idle]
G == 10: @assert open
-- c.ss --
[options]
delta_t 10
-- a.ss --
include "c.ss"
include "b.ss"
[all_states]
G == 20: @stop
-- file a.d --
a.html: a.sm a.ss b.ss c.ss
