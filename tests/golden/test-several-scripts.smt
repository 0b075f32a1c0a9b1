# Several scripts: those that fail, and how many.
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
[options]
delta_t 10
[all_states]
G == 20: @assert not open
G == 30: @stop
-- stdout --
1 passed, 1 failed
-- stderr --
bad.ss:4:18: error: assert failed after step 3 (G = 20, state Idle) [E0750]
    4 | G == 20: @assert not open
      |                  ^~~~~~~~ open = true
note: the last steps, and the values after each:
      step   G  state  open
         1   0  Idle   true
         2  10  Idle   true
         3  20  Idle   true
note: the machine has been in state 'Idle' from the start
a.sm:7:5: note: step 3 (G = 20): `open = true` was executed
1 error
-- exit --
1
