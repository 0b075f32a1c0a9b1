spec 6.13, 6.8  A state whose .entry makes a transition to the state itself begins again in every step, and its .step never runs.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 ins
U8 steps
U8 outs

[A]
.entry
    ins = ins + 1
    -> A
.step
    steps = steps + 1
.exit
    outs = outs + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 4: @assert ins == 5 and outs == 5 and steps == 0 and T == 0
G == 4: @stop
