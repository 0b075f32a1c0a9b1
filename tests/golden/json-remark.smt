# What hinders nothing is a note in JSON, and no error.
args --version >/dev/null; CC=nocc "$SMC" test --message-format=json case.smt >/dev/null

-- case.smt --
\-- app.sm --
[state_vector]
U64 G
U32 S
[Idle]
\-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert S == 1
G == 1: @stop
-- stderr --
{"severity":"note","code":null,"message":"engine c was left out: cannot run the C compiler nocc (the variable CC names another): No such file or directory","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
