# @print lines come before the report of a failed script too; the message has text and requirement.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
[Idle]
.step
    open = p > 5
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 7.5
G == 10: @expect open within 20 ms "the valve opens" @req R7
G == 20: @print p + 1, open "the level & more"
G == 20: @print S
G == 30: @assert open @req R7
G == 30: @fail "never at 30 < 40" @req R9
G == 40: @stop
-- stdout --
step 3 (G = 20), the level & more: p + 1 = 8.5, open = true
step 3 (G = 20): S = Idle, number 1
-- stderr --
a.ss:9:10: error: reached '@fail' in step 4 (G = 30, state Idle): never at 30 < 40 (R9) [E0755]
    9 | G == 30: @fail "never at 30 < 40" @req R9
      |          ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ G = 30
note: the last steps, and the values after each:
      step   G  state
         1   0  Idle
         2  10  Idle
         3  20  Idle
         4  30  Idle
note: the machine has been in state 'Idle' from the start
1 error
-- exit --
1
