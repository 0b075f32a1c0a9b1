# smc fix writes the name of a state for its number beside S, in machines and scripts, also in [all_states] and definitions: once. It leaves
# numbers of no state, and a number whose state has the name of a variable.
args check -Wextra app.sm
args fix -Wextra app.sm app.ss
args check -Wextra app.sm

-- app.sm --
[options]
time_unit s
[state_vector]
U64 G
U32 state @alias S
F64 x
bool y
bool Hold
[define]
running = S == 2 or x > 9
[all_states]
.step
    y = running
    (state) != (1): Hold = running and S != 3
[Idle]
.step
    x > 5 and 1 == S: -> Run
[Run]
.step
    S == 2.0 and x == 2: -> Hold
[Hold]
.step
    S == 4 or S == 2.5 or S == 0 or S >= 2: -> Idle
-- app.ss --
[options]
delta_t 1
[all_states]
G == 0: @assert S == 1
G == 2 && S == 1: @stop
-- stdout --
app.sm:10:
  - running = S == 2 or x > 9
  + running = S == Run or x > 9
app.sm:14:
  -     (state) != (1): Hold = running and S != 3
  +     (state) != (Idle): Hold = running and S != 3
app.sm:17:
  -     x > 5 and 1 == S: -> Run
  +     x > 5 and Idle == S: -> Run
app.sm:20:
  -     S == 2.0 and x == 2: -> Hold
  +     S == Run and x == 2: -> Hold
app.sm: 4 fixed
app.ss:4:
  - G == 0: @assert S == 1
  - G == 2 && S == 1: @stop
  + at 0: @assert S == Idle
  + G == 2 and S == Idle: @stop
app.ss: 4 fixed
-- stderr --
app.sm:10:16: warning: 2 is the number of the state 'Run' [W0440 state-number]
   10 | running = S == 2 or x > 9
      |                ^ write Run
app.sm:14:17: warning: 1 is the number of the state 'Idle' [W0440 state-number]
   14 |     (state) != (1): Hold = running and S != 3
      |                 ^ write Idle
app.sm:17:15: warning: 1 is the number of the state 'Idle' [W0440 state-number]
   17 |     x > 5 and 1 == S: -> Run
      |               ^ write Idle
app.sm:20:10: warning: 2.0 is the number of the state 'Run' [W0440 state-number]
   20 |     S == 2.0 and x == 2: -> Hold
      |          ^~~ write Run
app.sm:23:15: warning: this is never true: 'S' is a whole number and is never 2.5 [W0414 float-equality]
   23 |     S == 4 or S == 2.5 or S == 0 or S >= 2: -> Idle
      |               ^~~~~~~~
5 warnings
app.sm:23:15: warning: this is never true: 'S' is a whole number and is never 2.5 [W0414 float-equality]
   23 |     S == 4 or S == 2.5 or S == 0 or S >= 2: -> Idle
      |               ^~~~~~~~
1 warning
app.sm:23:15: warning: this is never true: 'S' is a whole number and is never 2.5 [W0414 float-equality]
   23 |     S == 4 or S == 2.5 or S == 0 or S >= 2: -> Idle
      |               ^~~~~~~~
1 warning
