# Messages other than diagnostics are in the document too.
args check --message-format=sarif a.sm missing.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valveOpen = true
-- stderr --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[]}},
"columnKind":"unicodeCodePoints",
"results":[],
"invocations":[{"executionSuccessful":false,"toolExecutionNotifications":[
{"level":"error","message":{"text":"cannot read 'missing.sm': No such file or directory"}}]}]}]}
-- exit --
3
