# A message format that does not exist.
args check --message-format=xml a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- stderr --
smc: --message-format is text, json or sarif, not 'xml'
Try 'smc check --help'.
-- exit --
2
