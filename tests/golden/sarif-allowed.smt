# A finding that an @allow silences is in the document with its reason, and nowhere else.
args check -Wno-dead-store --message-format=sarif a.sm
args check -w a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
U8 x
[A]
.step
    @allow(constant-range, "as much as fits")
    x = 300
    x = 300
    x  =  300   # the same
-- stderr --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[
{"id":"W0403","name":"constant-range","shortDescription":{"text":"'...' is ... and stores ... instead of ..."},"fullDescription":{"text":"The value does not fit the type of the variable. The variable then stores the nearest value of its type."},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"warning"},"properties":{"tags":["all","constant-range"]}}]}},
"columnKind":"unicodeCodePoints",
"results":[
{"ruleId":"W0403","ruleIndex":0,"level":"warning","message":{"text":"'x' is U8 and stores 255 instead of 300"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":9,"startColumn":9,"endLine":9,"endColumn":12}}}],"partialFingerprints":{"primaryLocationLineHash":"8b007e73b9c1f11c:2"},"suppressions":[]},
{"ruleId":"W0403","ruleIndex":0,"level":"warning","message":{"text":"'x' is U8 and stores 255 instead of 300"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":10,"startColumn":11,"endLine":10,"endColumn":14}}}],"partialFingerprints":{"primaryLocationLineHash":"8b007e73b9c1f11c:3"},"suppressions":[]},
{"ruleId":"W0403","ruleIndex":0,"level":"warning","message":{"text":"'x' is U8 and stores 255 instead of 300"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"a.sm"},"region":{"startLine":8,"startColumn":9,"endLine":8,"endColumn":12}}}],"partialFingerprints":{"primaryLocationLineHash":"8b007e73b9c1f11c:1"},"suppressions":[{"kind":"inSource","justification":"as much as fits"}]}]}]}
