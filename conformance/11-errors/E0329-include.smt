spec 1.11   A file includes no other; words that would include one may be names.

-- app.sm --
include "common.sm"                 #! E0329 cannot include another
import common                       #! E0329 cannot include another
[state_vector]
include <common.sv>                 #! E0329 cannot include another
U64 G
U32 S
F64 p @read_only
U8 include
[Idle]
.step
    include 'vent.sm'               #! E0329 cannot include another
    include = 5
    include > 3: include = 4
    include { include = 1 }
    include < p and p > 5: include = 6
    p < include > p: include = 7
    using the                       #! E0329 cannot include another
    require the                     #! E0329 cannot include another
    require two words               #! E0328
