# Wrong input has exit code 2, as of diff: 1 always means another behaviour.
args diff a.sm
args diff a.sm a.sm a.sm
args diff a.sm bad.sm
args diff bad.sm a.sm
args diff a.sm missing.sm
args diff a.sm a.rq
args diff a.sm a.sm --format=pdf
args diff a.sm a.sm -o a.sm
args diff a.sm a.sm bad.ss
args diff a.sm a.sm --max-steps=0

-- a.sm --
[state_vector]
U64 G
U32 S
[A] @safe
-- bad.sm --
[state_vector]
U64 G
U32 S
[A] @safe
.step
    -> B
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 0: x = 1
G == 0: @stop
-- a.rq --
-- stderr --
smc: diff requires two machines, the old one and the new one, as in 'smc diff old.sm new.sm'
Try 'smc diff --help'.
smc: diff requires two machines, the old one and the new one, as in 'smc diff old.sm new.sm'
Try 'smc diff --help'.
bad.sm:6:8: error: unknown state 'B' [E0501]
    6 |     -> B
      |        ^ add a section [B]
1 error
bad.sm:6:8: error: unknown state 'B' [E0501]
    6 |     -> B
      |        ^ add a section [B]
1 error
smc: cannot read 'missing.sm': No such file or directory
smc: 'a.rq' is neither a machine (.sm) nor a script (.ss)
Try 'smc diff --help'.
smc: --format is text, markdown, json or svg, not 'pdf'
Try 'smc diff --help'.
smc: 'a.sm' is an input of this command and cannot be its output; name another file after -o
Try 'smc diff --help'.
bad.ss:4:9: error: unknown element 'x' [E0204]
    4 | G == 0: x = 1
      |         ^
1 error
smc: --max-steps requires a whole number from 1, not '0'
Try 'smc diff --help'.
-- exit --
2 2 2 2 3 2 2 2 2 2
