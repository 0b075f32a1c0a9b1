# A message of the command that begins with "warning:" is a warning in JSON, and no error.
args key a.key >/dev/null; umask 022; "$SMC" build a.sm -o a.smb; chmod 640 a.key; "$SMC" sign a.smb --key=a.key --number=1 -o b.smb --message-format=json

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
{"severity":"warning","code":null,"message":"other users can read 'a.key'; 'chmod 600 a.key' makes it private","file":null,"line":null,"column":null,"endLine":null,"endColumn":null,"label":null,"notes":[],"edits":[],"flag":null,"group":null}
