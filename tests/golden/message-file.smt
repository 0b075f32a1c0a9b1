# --message-file: the messages as JSON or SARIF in a file, while standard error has them as text. The file's name decides if no format is named.
args check a.sm missing.sm --message-file=out.json
args build a.sm -w --message-file=none.json
args build a.sm --message-format=json --message-file=out.txt -Werror -o made/
args check a.sm --message-file=out.sarif

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
U8 spare
bool open
[Idle]
.step
    open = p > 5
    p > 50: -> Abort
[Abort]
.step
    open = true
-- file out.json --
{"severity":"error","code":null,"message":"cannot read 'missing.sm': No such file or directory","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
-- file out.txt --
{"severity":"error","code":"W0203","message":"element 'spare' is never used","file":"a.sm","line":5,"column":4,"endLine":5,"endColumn":9,"label":null,"notes":[],"edits":[],"flag":"unused-element","group":"all"}
-- file out.sarif --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[
{"id":"W0203","name":"unused-element","shortDescription":{"text":"element '...' is never used"},"fullDescription":{"text":"[..]"},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"warning"},"properties":{"tags":["all","unused-element"]}}]}},
"columnKind":"unicodeCodePoints",
"results":[
{"ruleId":"W0203","ruleIndex":0,"level":"warning","message":{"text":"element 'spare' is never used"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":5,"startColumn":4,"endLine":5,"endColumn":9}}}],"partialFingerprints":{"primaryLocationLineHash":"b9fb2874e2772c12:1"}}]}]}
-- stderr --
smc: cannot read 'missing.sm': No such file or directory
a.sm:5:4: error: element 'spare' is never used [W0203 unused-element]
    5 | U8 spare
      |    ^~~~~
1 error
a.sm:5:4: warning: element 'spare' is never used [W0203 unused-element]
    5 | U8 spare
      |    ^~~~~
1 warning
-- exit --
3 0 1 0
