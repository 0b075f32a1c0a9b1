# A warning names a key file that the group or others can read.  One that only its owner can read draws none, and a new key is made so.
args key a.key >/dev/null; umask 022; "$SMC" build a.sm -o a.smb; chmod 640 a.key; "$SMC" sign a.smb --key=a.key --number=1 -o b.smb
args --version >/dev/null; chmod 604 a.key; "$SMC" sign a.smb --key=a.key --number=1 -o c.smb
args --version >/dev/null; chmod 600 a.key; "$SMC" sign a.smb --key=a.key --number=1 -o d.smb
args --version >/dev/null; umask 000; "$SMC" key b.key >/dev/null; ls -l b.key | cut -c 1-10

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
-rw-------
-- stderr --
smc: warning: other users can read 'a.key'; 'chmod 600 a.key' makes it private
smc: warning: other users can read 'a.key'; 'chmod 600 a.key' makes it private
