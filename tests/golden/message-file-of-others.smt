# Also the commands that draw, report and fix write their messages to a file.
args report a.sm a.ss -o a.html --message-file=report.json
args graph a.sm a.ss -o a.svg --message-file=graph.sarif
args fix b.sm --message-file=fix.json
args fix b.sm --message-file=-

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open
[Idle]
.step
    open = p > 5
    p > 50: -> Abort
[Abort]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- b.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true && fals
-- file report.json --
{"severity":"error","code":null,"message":"a.ss failed; the report shows why","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
-- file graph.sarif --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[
{"id":"E0750","name":"assert_failed","shortDescription":{"text":"assert failed after step ... (G = ..., state ...)..."},"fullDescription":{"text":"[..]"},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"error"}}]}},
"columnKind":"unicodeCodePoints",
"results":[
{"ruleId":"E0750","ruleIndex":0,"level":"error","message":{"text":"assert failed after step 3 (G = 20, state Idle) (open = false)"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.ss"},"region":{"startLine":5,"startColumn":13,"endLine":5,"endColumn":17}}}],"relatedLocations":[{"message":{"text":"the last steps, and the values after each:\u000astep   G  state   open\u000a   1   0  Idle   false\u000a   2  10  Idle   false\u000a   3  20  Idle   false"}},{"message":{"text":"the machine has been in state 'Idle' from the start"}},{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":8,"startColumn":5,"endLine":8,"endColumn":17}},"message":{"text":"step 3 (G = 20): `open = p > 5` stored false: p = 0"}}],"partialFingerprints":{"primaryLocationLineHash":"3cfb2d9a251ba18d:1"}}]}]}
-- file fix.json --
{"severity":"error","code":"E0204","message":"unknown element 'fals'","file":"b.sm","line":7,"column":21,"endLine":7,"endColumn":25,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
-- stdout --
b.sm:7:
  -     open = true && fals
  +     open = true and fals
b.sm: 1 fixed
b.sm:7:21: error: unknown element 'fals' [E0204]
    7 |     open = true and fals
      |                     ^~~~
1 error
-- stderr --
smc: a.ss failed; the report shows why
a.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) [E0750]
    5 |     @assert open
      |             ^~~~ open = false
note: the last steps, and the values after each:
      step   G  state   open
         1   0  Idle   false
         2  10  Idle   false
         3  20  Idle   false
note: the machine has been in state 'Idle' from the start
a.sm:8:5: note: step 3 (G = 20): `open = p > 5` stored false: p = 0
1 error
b.sm:7:21: error: unknown element 'fals' [E0204]
    7 |     open = true and fals
      |                     ^~~~
1 error
b.sm:7:21: error: unknown element 'fals' [E0204]
    7 |     open = true and fals
      |                     ^~~~
1 error
-- exit --
1 1 1 1
