# No answer names an infinite input, and a limit that the type cannot have is no value to try.
args why a.sm a.ss --to=Abort

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
F32 q @read_only

[Fill]
.step
    p > 1.7976931348623157e308: -> Abort
    q > 1e300: -> Abort
    q > 3.4028234663852886e38: -> Abort

[Abort] @abort @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 1
G == 20: @stop
-- stdout --
step 3 (G = 20): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:9: `p > 1.7976931348623157e308` was false since step 1 (G = 0): p = 1
  a.sm:10: `q > 1e300` was false since step 1 (G = 0): q = 0
  a.sm:11: `q > 3.4028234663852886e38` was false since step 1 (G = 0): q = 0
a.sm:9: Fill -> Abort was never taken, and no step was nearer to taking it than this one
where the values come from:
  a.ss:4: the script wrote p in step 1, by `p = 1`
  a.sm:5: nothing has written q, so it has its first value
