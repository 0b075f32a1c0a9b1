# A parameter has one value: a second one, the same one too, is an error in each command with --set.
args test a.sm a.ss --set limit=40 --set n=2 --set limit=50
args test a.sm a.ss --set limit=40 --set=limit=40
args test a.sm a.ss --set limit=4000 --set=limit=40
args why a.sm a.ss --to=Done --set n=2 --set n=2
args faults a.sm a.ss --set n=2 --set n=2
args sweep a.sm a.ss --set n=2 --set limit=1:9:5 --set n=2
args test x.app x.ss --set a.n=2 --set a.limit=3 --set a.n=3

-- a.sm --
[state_vector]
U64 G
U32 S
bool on
[local]
F64 limit = 45 @parameter @range 0 100
U8 n = 3 @parameter @range 1 9
[Wait]
.step
    on = n > 1
    T >= limit: -> Done
[Done] @safe
.entry
    on = false
-- a.ss --
[options]
delta_t 10
[all_states]
G == 100: @assert state Done
G == 100: @stop
-- x.app --
[options]
state_vector "x.sv"
time G 1 ms
[start]
S = 1
[flight]
every 10 ms:
    machine a "a.sm"
-- x.sv --
[V]
U64 G
U32 S
bool on
-- x.ss --
[all_states]
G == 100: @stop
-- stderr --
smc: parameter 'limit' is set twice: remove one of its values
Try 'smc test --help'.
smc: parameter 'limit' is set twice: remove one of its values
Try 'smc test --help'.
smc: cannot set parameter 'limit' to 4000: the value is above the range
smc: parameter 'n' is set twice: remove one of its values
Try 'smc why --help'.
smc: parameter 'n' is set twice: remove one of its values
Try 'smc faults --help'.
smc: parameter 'n' is set twice: remove one of its values
Try 'smc sweep --help'.
smc: parameter 'a.n' is set twice: remove one of its values
Try 'smc test --help'.
-- exit --
2 2 1 2 2 2 2
