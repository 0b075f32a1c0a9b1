spec 7.33   An advance of two steps is no gap; a longer one, here of a machine that a mode stops, begins a new run.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    machine guard "guard.sm" @mode running
-- rocket.sv --
[A]
U64  time
U32  state
U8   running
F64  p
bool a
bool b
-- guard.sm --
[options]
step 10 ms
[state_vector]
U64  time  @alias G
U32  state @alias S
F64  p     @read_only
bool a
bool b
[Run]
.step
    a = held(p < 5, 20 ms)
    b = held(p < 5, 3 steps)
-- flight.ss --
[all_states]
at 0: running = 2
at 30: running = 1
at 40: running = 2
at 60: running = 1
at 80: running = 2
at 10: @assert not a and not b
at 20: @assert a and b
at 40: @assert a and b
at 50: @assert a and b
at 80: @assert not a and not b
at 90: @assert not a and not b
at 100: @assert a and b
at 100: @stop
