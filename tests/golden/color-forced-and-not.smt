# CLICOLOR_FORCE colours, NO_COLOR does not.
args --version; NO_COLOR=1 CLICOLOR_FORCE=1 "$SMC" check a.sm
args --version; CLICOLOR_FORCE=1 "$SMC" check a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- stdout --
smc [..]
smc [..]
-- stderr --
a.sm:7:5: error: unknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     ^~~~~~~~~ did you mean 'valveOpen'?
a.sm:4:6: note: 'valveOpen' is declared here
1 error
[1ma.sm:7:5: [0m[1;31merror: [0munknown element 'valve0pen' [E0204]
    7 |     valve0pen = true
      |     [1;32m^~~~~~~~~ did you mean 'valveOpen'?[0m
[1ma.sm:4:6: [0m[1;36mnote: [0m'valveOpen' is declared here
1 error
-- exit --
1 1
