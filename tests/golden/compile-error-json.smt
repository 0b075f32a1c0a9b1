# The same as JSON, one object a line.
args check --message-format=json a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool valveOpen
[Idle]
.step
    valve0pen = true
-- stderr --
{"severity":"error","code":"E0204","message":"unknown element 'valve0pen'","file":"a.sm","line":7,"column":5,"endLine":7,"endColumn":14,"label":"did you mean 'valveOpen'?","notes":[{"message":"'valveOpen' is declared here","file":"a.sm","line":4,"column":6,"endLine":4,"endColumn":15,"step":null}],"edits":[],"flag":null,"group":null}
-- exit --
1
