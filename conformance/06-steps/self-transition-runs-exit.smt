spec 6.13  A transition to the same state runs .exit, and .entry in the next step, where T is 0.

-- app.sm --
[state_vector]
U64 G
U32 S
U8 ins
U8 outs
F64 x

[A]
.entry
    ins = ins + 1
.step
    x = T
    T == 2: -> A
.exit
    outs = outs + 1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: @assert x == 0 and ins == 1 and outs == 0 and T == 0
G == 1: @assert x == 1 and ins == 1 and outs == 0 and T == 1
G == 2: @assert x == 2 and ins == 1 and outs == 1 and T == 2
G == 3: @assert x == 0 and ins == 2 and outs == 1 and T == 0
G == 4: @assert x == 1 and ins == 2 and outs == 1 and T == 1
G == 5: @assert x == 2 and ins == 2 and outs == 2 and T == 2
G == 6: @assert x == 0 and ins == 3 and outs == 2 and T == 0
G == 7: @assert x == 1 and ins == 3 and outs == 2 and T == 1
G == 7: @stop
