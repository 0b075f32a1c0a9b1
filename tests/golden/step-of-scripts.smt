# Without --step the step is the delta_t of the scripts, where they agree; the report says which step its findings rely on.
args check -Wflight --step=100 a.sm
args check -Wflight a.sm a.ss
args test -Wflight -Werror a.sm a.ss
args test -Wflight -Werror --step=100 a.sm other.ss
args build -Wflight --step=100 a.sm
args test -Wflight -Werror a.sm a.ss other.ss
args report a.sm a.ss --format=text | tr '\n' ' ' | grep -oE '  window-not-full  |(Time advances|The time per step)[^.]*[.]'
args report a.sm other.ss --step=100 --format=text | tr '\n' ' ' | grep -oE '  window-not-full  |(Time advances|The time per step)[^.]*[.]'
args report a.sm a.ss other.ss --format=text | tr '\n' ' ' | grep -oE '  window-not-full  |(Time advances|The time per step)[^.]*[.]'
args report a.sm --format=text | tr '\n' ' ' | grep -oE '  window-not-full  |(Time advances|The time per step)[^.]*[.]'
args report a.sm --step=x --format=text
args test a.sm a.ss --step=0

-- a.sm --
[state_vector]
U64   time   @alias G
U32   state  @alias S
F64   p      @read_only
[Start]
.step
    T > 1000 and roll_avg(p, 20) > 500: -> Run
[Run] @safe
-- a.ss --
[options]
delta_t 100
[all_states]
G == 0: p = 600
G == 2900: @assert S == 2
G == 3000: @stop
-- other.ss --
[options]
delta_t 50
[all_states]
G == 0: p = 600
G == 2900: @assert S == 2
G == 3000: @stop
-- stdout --
2 passed, 0 failed
Time advances by 100 per step, the `delta_t` of the scripts.
  window-not-full  
Time advances by 100 per step, the value of `--step`.
  window-not-full  
The time per step is unknown, because the scripts do not all have the same `delta_t`.
The time per step is unknown.
-- stderr --
a.sm:7:5: warning: this guard can be true too early: the window of 'roll_avg(p, 20)' has 12 of 20 samples [W0965 window-not-full]
    7 |     T > 1000 and roll_avg(p, 20) > 500: -> Run
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
1 warning
a.sm:7:5: warning: this guard can be true too early: the window of 'roll_avg(p, 20)' has 12 of 20 samples [W0965 window-not-full]
    7 |     T > 1000 and roll_avg(p, 20) > 500: -> Run
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
1 warning
a.sm:7:5: error: this guard can be true too early: the window of 'roll_avg(p, 20)' has 12 of 20 samples [W0965 window-not-full]
    7 |     T > 1000 and roll_avg(p, 20) > 500: -> Run
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
1 error
a.sm:7:5: error: this guard can be true too early: the window of 'roll_avg(p, 20)' has 12 of 20 samples [W0965 window-not-full]
    7 |     T > 1000 and roll_avg(p, 20) > 500: -> Run
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
1 error
a.sm:7:5: warning: this guard can be true too early: the window of 'roll_avg(p, 20)' has 12 of 20 samples [W0965 window-not-full]
    7 |     T > 1000 and roll_avg(p, 20) > 500: -> Run
      |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
1 warning
smc: --step requires a whole number from 1, not 'x'
Try 'smc report --help'.
smc: --step requires a whole number from 1, not '0'
Try 'smc test --help'.
-- exit --
0 0 1 1 0 0 0 0 0 0 2 2
