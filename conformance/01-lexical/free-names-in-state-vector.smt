spec 1.11  Any other word may name an element: words of the machine, of scripts and functions too.

-- app.sv --
[R]
U64 G
U32 S
F64 T
F64 lock
F64 entry
F64 local
F64 state_vector
F64 abs
F64 roll_avg
F64 read_only
F64 assert
F64 delta_t
F64 options
F64 all_states

-- app.sm --
[state_vector]
U64 G
U32 S
F64 lock
F64 entry
F64 local
F64 state_vector
F64 abs
F64 roll_avg
F64 read_only
F64 assert
F64 delta_t
F64 options
F64 all_states

[Run]
.step
    lock = 1
    entry = 2
    local = 3
    state_vector = 4
    abs = abs(-5)
    roll_avg = 6
    read_only = 7
    assert = 8
    delta_t = 9
    options = 10
    all_states = 11

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert lock == 1
    @assert entry == 2
    @assert local == 3
    @assert state_vector == 4
    @assert abs == 5
    @assert roll_avg == 6
    @assert read_only == 7
    @assert assert == 8
    @assert delta_t == 9
    @assert options == 10
    @assert all_states == 11
    @stop
}
