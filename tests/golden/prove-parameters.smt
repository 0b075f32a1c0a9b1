# What is proved is true of every setting of a parameter; if only the value in the source fulfils a requirement, the verdict says so.
args prove a.sm a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 out
F64 other
bool ready
[local]
F64 limit = 40 @parameter @range 30 50
U8 count = 3 @parameter @range 2 4
bool on = true @parameter
[Run]
.step
    out = limit * 2
    other = count
    ready = on
-- a.rq --
R1 "every setting"                  always out >= 60 and out <= 100
R2 "the default alone, from below"  always out >= 70
R3 "the default alone, from above"  always out <= 90
R4 "every count"                    always 2 <= other <= 4
R5 "the default of the count"       always other > 2
R6 "the default of a bool"          always ready
R7 "not even the default"           never  out > 79 and out < 81
-- stdout --
requirements of a, from state Run, with a step every 10 ms:
  R1  proved              every setting
      in Run: out is from 60 to 100
  R2  proved              the default alone, from below
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: out is 80
  R3  proved              the default alone, from above
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: out is 80
  R4  proved              every count
      in Run: other is from 2 to 4
  R5  proved              the default of the count
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: other is 3
  R6  proved              the default of a bool
      assuming that the parameters have the values in the source (smc sweep tries others)
      in Run: ready is true
  R7  violated            not even the default
      after 1 steps
      # Violates R7 (not even the default).

      [options]
      delta_t    10 ms
      init_state Run

      [all_states]
      at 0: @assert state Run and out == 80 and other == 3 and ready
      at 0: @stop
-- exit --
1
