# The file of messages is an output like others: never a source, nor a file by another program, nor another output of the command.
args check a.sm --message-file=b.sm
args check a.sm --message-file=notes.json
args build a.sm -o x.smb --message-file=./x.smb
args report a.sm --message-file=-
args test a.sm a.ss --tap --message-file=-
args disasm a.smb --message-file=out.json
args disasm a.smb --message-format=sarif
args check --message-file=out.json
args build a.sm
args build a.sm --message-file=a.smb
args verify a.smb

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
G == 20: @stop
-- notes.json --
{"severity": "none"}
-- file notes.json --
{"severity": "none"}
-- stdout --
a.smb: machine 1: 2 states, longest step 7 instructions, 96 bytes of RAM on a 64-bit computer, state vector 32 bytes (layout 72834df1)
-- stderr --
smc: 'b.sm' is the name of a source, and only 'smc fix' writes to sources; name another file after --message-file
Try 'smc check --help'.
smc: 'notes.json' exists and was not written by smc; use another name, or --force to replace it
Try 'smc check --help'.
smc: -o and --message-file name the same file
Try 'smc build --help'.
smc: this output and --message-file cannot both write to standard output
Try 'smc report --help'.
smc: --tap and --message-file cannot both write to standard output
Try 'smc test --help'.
smc: option '--message-file' is not an option of 'smc disasm'
Try 'smc disasm --help'.
smc: --message-format=sarif is for commands that read sources: build, check, test, report, graph and fix
Try 'smc disasm --help'.
smc: check requires a file, as in 'smc check tank.sm'
Try 'smc check --help'.
smc: 'a.smb' and 'a.smb' would be the same file; use another name
Try 'smc build --help'.
-- exit --
2 2 2 2 2 2 2 2 0 2 0
