# --emit=ast shows every annotation with what it takes, as written.
args build --emit=ast a.sm

-- a.sm --
[state_vector]
U64 G
U32 S @read_only @alias s
F64 x @range - 0x2 4e1
[Abort] @safe
    @abort
.entry
    x = 1
-- stdout --
# Syntax tree of a.sm, printed by smc
state_vector state_vector
  U64 G
  U32 S @read_only @alias s
  F64 x @range - 0x2 4e1
state Abort @safe @abort
  .entry
    x = 1
