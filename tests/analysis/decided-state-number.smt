# S is the number of a state: an assert or a requirement about another number tests nothing.
analyses on

-- app.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool on
[A]
.step
    on = false
    p > 5: -> B
[B] @safe
.step
    on = true
-- app.rq --
R1 "no fifth state"  never S == 5                             #! W1304 R1 is never violated
R2 "no third state"  always S < 3                             #! W1304 R2 is never violated
R3 "the second"      never S == 2 and not on
-- app.ss --
[all_states]
at 0:     @assert S != 3                                      #! W0752
at 0:     @assert S < 2
at 10 ms: p = 6
at 30 ms: @assert S == 2 and on
at 30 ms: @stop
