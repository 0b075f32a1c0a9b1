spec 2.31, 5.60  In an application T and G of a machine without times count the unit of the application.
warn

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 us
[flight]
every 20 ms:
    machine m "m.sm"
-- rocket.sv --
[A]
U64 time
U32 state
F64 delay
F64 limit
F64 x
-- m.sm --
[state_vector]
U64 time  @alias G
U32 state @alias S
F64 delay @unit ms @read_only
F64 limit @unit us @read_only
F64 x
[A]
.step
    T > delay: x = 1          #! W0448 'T' has the unit us, but 'delay' has the unit ms
    T > limit: -> B
[B] @safe
