spec 10.29, 10.30   The right sides are elements of the state vector, not of the machine: bindings can cross, and never chain.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine m "copy.sm" { from = to  to = from }
    machine n "copy.sm" { from = to  to = third  state = otherState }
-- rocket.sv --
[A]
U64  time
U32  state
U32  otherState
F64  from
F64  to
F64  third
-- copy.sm --
[state_vector]
U64  time  @alias G
U32  state @alias S
F64  from  @read_only
F64  to

[Run] @safe
.step
    to = from + 1
-- flight.ss --
[all_states]
G == 0: to = 5
G == 0: @assert from == 6 and to == 5 and third == 6
G == 0: @assert m.from == to and m.to == from and n.from == to and n.to == third      #! W0752 tests nothing
G == 10: to = 9
G == 10: @assert from == 10 and third == 10
G == 10: @stop
