# An included file that cannot be read is an error at the line that names it.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
include "parts/plant.ss"
[options]
delta_t 10
[all_states]
G == 20: @stop
-- stderr --
a.ss:1:9: error: cannot include 'parts/plant.ss': No such file or directory [E0707]
    1 | include "parts/plant.ss"
      |         ^~~~~~~~~~~~~~~~
1 error
-- exit --
1
