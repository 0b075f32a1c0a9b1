# - is standard input; the messages call it <stdin>.
args check - <a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- stderr --
<stdin>:7:5: error: unknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     ^~~~~~~~~ did you mean 'valveOpen'?
<stdin>:4:6: note: 'valveOpen' is declared here
1 error
-- exit --
1
