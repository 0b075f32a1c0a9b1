# --emit=ast
args build --emit=ast a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
# Syntax tree of a.sm, printed by smc
state_vector state_vector
  U64 G
  U32 S
  bool open
state Idle
  .step
    open = true
