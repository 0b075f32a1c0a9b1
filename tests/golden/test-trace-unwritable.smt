# A trace that cannot be written.
args test --trace=nowhere/t.txt a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 20 {
    @assert open
    @stop
}
-- stderr --
smc: cannot write 'nowhere/t.txt': No such file or directory
-- exit --
3
