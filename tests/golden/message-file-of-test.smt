# The messages of a test in a file: findings in sources, failures of scripts, and cases that failed.
args test a.sm a.ss --message-file=out.json
args test a.sm a.ss b.smt --message-file=out.sarif --tap
args test b.smt --message-file=out.txt
args test b.smt --message-file=out.txt

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
-- b.smt --
\-- b.sm --
[state_vector]
U64 G
U32 S
[Idle]
\-- b.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert G == 30
    @stop
}
-- file out.json --
{"severity":"error","code":"E0750","message":"assert failed after step 3 (G = 20, state Idle)","file":"a.ss","line":5,"column":13,"endLine":5,"endColumn":17,"label":"open = false","notes":[{"message":"the last steps, and the values after each:\u000astep   G  state   open\u000a   1   0  Idle   false\u000a   2  10  Idle   false\u000a   3  20  Idle   false","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"step":null},{"message":"the machine has been in state 'Idle' from the start","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"step":null},{"message":"step 3 (G = 20): `open = p > 5` stored false: p = 0","file":"a.sm","line":8,"column":5,"endLine":8,"endColumn":17,"step":null}],"edits":[],"flag":null,"group":null}
-- file out.sarif --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[
{"id":"E0750","name":"assert_failed","shortDescription":{"text":"assert failed after step ... (G = ..., state ...)..."},"fullDescription":{"text":"[..]"},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"error"}}]}},
"columnKind":"unicodeCodePoints",
"results":[
{"ruleId":"E0750","ruleIndex":0,"level":"error","message":{"text":"assert failed after step 3 (G = 20, state Idle) (open = false)"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.ss"},"region":{"startLine":5,"startColumn":13,"endLine":5,"endColumn":17}}}],"relatedLocations":[{"message":{"text":"the last steps, and the values after each:\u000astep   G  state   open\u000a   1   0  Idle   false\u000a   2  10  Idle   false\u000a   3  20  Idle   false"}},{"message":{"text":"the machine has been in state 'Idle' from the start"}},{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":8,"startColumn":5,"endLine":8,"endColumn":17}},"message":{"text":"step 3 (G = 20): `open = p > 5` stored false: p = 0"}}],"partialFingerprints":{"primaryLocationLineHash":"3cfb2d9a251ba18d:1"}}],
"invocations":[{"executionSuccessful":false,"toolExecutionNotifications":[
{"level":"error","message":{"text":"b.smt: failed\u000a    b.ss should pass, but failed\u000a    not announced: b.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) (G = 20) [E0750]"}}]}]}]}
-- file out.txt --
smc: b.smt: failed
    b.ss should pass, but failed
    not announced: b.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) (G = 20) [E0750]
-- stdout --
TAP version 13
1..2
not ok 1 - a.ss
# a.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) [E0750]
#     5 |     @assert open
#       |             ^~~~ open = false
# note: the last steps, and the values after each:
#       step   G  state   open
#          1   0  Idle   false
#          2  10  Idle   false
#          3  20  Idle   false
# note: the machine has been in state 'Idle' from the start
# a.sm:8:5: note: step 3 (G = 20): `open = p > 5` stored false: p = 0
# 1 error
not ok 2 - b.smt
# b.ss should pass, but failed
# not announced: b.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) (G = 20) [E0750]
0 passed, 1 failed
0 passed, 1 failed
-- stderr --
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
b.smt: failed
    b.ss should pass, but failed
    not announced: b.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) (G = 20) [E0750]
b.smt: failed
    b.ss should pass, but failed
    not announced: b.ss:5:13: error: assert failed after step 3 (G = 20, state Idle) (G = 20) [E0750]
-- exit --
1 1 1 1
