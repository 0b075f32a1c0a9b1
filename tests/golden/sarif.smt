# The same as one SARIF document: rules that were broken, results with places, notes and edits.
args check --message-format=sarif "my app.sm"

-- my app.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
    valveOpen && true: valveOpen = false
-- stderr --
{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{
"tool":{"driver":{"name":"smc","version":"[..]","rules":[
{"id":"E0107","name":"foreign_operator","shortDescription":{"text":"'...' is written '...' here"},"fullDescription":{"text":"This operator is spelled as in another language."},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"error"}},
{"id":"E0204","name":"unknown_element","shortDescription":{"text":"unknown element '...'"},"fullDescription":{"text":"This name is not an element listed in [state_vector], not a local and not T."},"help":{"text":"[..]","markdown":"[..]"},"defaultConfiguration":{"enabled":true,"level":"error"}}]}},
"columnKind":"unicodeCodePoints",
"results":[
{"ruleId":"E0204","ruleIndex":1,"level":"error","message":{"text":"unknown element 'valve0pen' (did you mean 'valveOpen'?)"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"my%20app.sm"},"region":{"startLine":7,"startColumn":5,"endLine":7,"endColumn":14}}}],"relatedLocations":[{"physicalLocation":{"artifactLocation":{"uri":"my%20app.sm"},"region":{"startLine":4,"startColumn":6,"endLine":4,"endColumn":15}},"message":{"text":"'valveOpen' is declared here"}}],"partialFingerprints":{"primaryLocationLineHash":"85e801a72f6d8a67:1"}},
{"ruleId":"E0107","ruleIndex":0,"level":"error","message":{"text":"'&&' is written 'and' here (write and)"},"locations":[{"physicalLocation":{"artifactLocation":{"uri":"my%20app.sm"},"region":{"startLine":8,"startColumn":15,"endLine":8,"endColumn":17}}}],"partialFingerprints":{"primaryLocationLineHash":"fc5bb243a40182bb:1"},"fixes":[{"artifactChanges":[{"artifactLocation":{"uri":"my%20app.sm"},"replacements":[{"deletedRegion":{"startLine":8,"startColumn":15,"endLine":8,"endColumn":17},"insertedContent":{"text":"and"}}]}]}]}]}]}
-- exit --
1
