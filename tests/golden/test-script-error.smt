# A script that does not compile.
args test a.sm a.ss bad.ss

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
-- bad.ss --
[all_states]
opne: @stop
-- stdout --
1 passed, 1 failed
-- stderr --
bad.ss:1:1: error: the script does not define how far G advances in a step; add delta_t to [options] [E0701]
    1 | [all_states]
      | ^
bad.ss:2:1: error: unknown element 'opne' [E0204]
    2 | opne: @stop
      | ^~~~ did you mean 'open'?
a.sm:4:6: note: 'open' is declared here
2 errors
-- exit --
1
