spec 1.3  A byte-order mark before the first character of each file is skipped.

-- app.sm --
﻿[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 1

-- app.ss --
﻿[options]
delta_t 1

[all_states]
true {
    @assert x == 1
    @stop
}
