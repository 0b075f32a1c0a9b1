# Pins want their state vector, and give C.
args build a.io --emit=c
args build a.io --sv v.sv
args check a.io
args check a.io --sv v.sv
args a.io
args build a.io --emit=ast && cat a.io >/dev/null

-- v.sv --
[Valves]
bool open
-- a.io --
[digital]
o 0 open @safe true
o 1 open @allow(two-writers, "why")
-- stdout --
# Syntax tree of a.io, printed by smc
pins digital
  o 0 open @safe true
  o 1 open @allow(two-writers, "why")
-- stderr --
smc: pins and messages are built with their state vector, as in 'smc build a.io --sv app.sv --emit=c'
Try 'smc build --help'.
smc: pins and messages alone can only become C; add --emit=c
Try 'smc build --help'.
smc: pins and messages are checked with their state vector, as in 'smc check a.io --sv app.sv'
Try 'smc check --help'.
smc: a command precedes the file, as in 'smc check a.io'
Try 'smc --help'.
-- exit --
2 2 2 0 2 0
