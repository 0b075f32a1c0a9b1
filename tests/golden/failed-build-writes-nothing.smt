# A build that fails leaves what was there.
args build a.sm; ls; cat a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- a.smb --
old
-- stdout --
a.sm
a.smb
old
-- stderr --
a.sm:7:5: error: unknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     ^~~~~~~~~ did you mean 'valveOpen'?
a.sm:4:6: note: 'valveOpen' is declared here
1 error
