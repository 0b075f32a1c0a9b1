# Several transitions of [all_states] to one state propose it once for @except; a list that exists is extended.
args fix -w a.sm
args check -w a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[all_states]
.step
    p > 3: -> Abort
    p > 4 {
        p < 9: -> Abort
        -> Safe
    }
[all_states] @except Safe
.step
    p > 5: -> Abort
    p > 6: -> Abort
    x = p
[Run]
[Abort]
[Safe]
-- file a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F64 x
[all_states] @except Abort Safe
.step
    p > 3: -> Abort
    p > 4 {
        p < 9: -> Abort
        -> Safe
    }
[all_states] @except Safe Abort
.step
    p > 5: -> Abort
    p > 6: -> Abort
    x = p
[Run]
[Abort]
[Safe]
-- stdout --
a.sm:6:
  - [all_states]
  + [all_states] @except Abort Safe
a.sm:13:
  - [all_states] @except Safe
  + [all_states] @except Safe Abort
a.sm: 3 fixed
