# What is read is never written over, under no name and by no option.
args build a.sm -o a.sm
args report a.sm -o ./a.sm
args graph a.sm -o a.sm
args build a.sm -MD -MF a.sm
args check a.sm
args test a.sm a.ss --trace=a.sm
args test a.sm a.ss --junit=a.ss
args build a.sm --sv a.sv -o a.sv

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- a.sv --
[R]
U64 G
U32 S
-- a.ss --
[options]
delta_t 1
[all_states]
G == 1: @stop
-- file a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stderr --
smc: 'a.sm' is an input of this command and cannot be its output; name another file after -o
[..]
smc: './a.sm' is an input of this command and cannot be its output; name another file after -o
[..]
smc: 'a.sm' is an input of this command and cannot be its output; name another file after -o
[..]
smc: 'a.sm' is an input of this command and cannot be its output; name another file after -MF
[..]
smc: 'a.sm' is an input of this command and cannot be its output; name another file after --trace
[..]
smc: 'a.ss' is an input of this command and cannot be its output; name another file after --junit
[..]
smc: 'a.sv' is an input of this command and cannot be its output; name another file after -o
[..]
-- exit --
2 2 2 2 0 2 2 2
