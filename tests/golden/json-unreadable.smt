# Messages other than diagnostics are lines of JSON too.
args check --message-format=json missing.sm

-- stderr --
{"severity":"error","code":null,"message":"cannot read 'missing.sm': No such file or directory","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
-- exit --
3
