# Diagnostics of a run as JSON.
args test --message-format=json a.sm bad.ss >/dev/null

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert not open
G == 30: @stop
-- stderr --
{"severity":"error","code":"E0750","message":"assert failed after step 3 (G = 20, state Idle)","file":"bad.ss","line":4,"column":18,"endLine":4,"endColumn":26,"label":"open = true","notes":[{"message":"the last steps, and the values after each:\u000astep   G  state  open\u000a   1   0  Idle   true\u000a   2  10  Idle   true\u000a   3  20  Idle   true","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"step":null},{"message":"the machine has been in state 'Idle' from the start","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"step":null},{"message":"step 3 (G = 20): `open = true` was executed","file":"a.sm","line":7,"column":5,"endLine":7,"endColumn":16,"step":null}],"edits":[],"flag":null,"group":null}
-- exit --
1
