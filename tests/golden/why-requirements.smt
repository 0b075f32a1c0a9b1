# Without a question about a state, the first step that violates a requirement is explained; the state that it demands was never reached.
args why a.sm a.ss a.rq
args why a.sm a.ss a.rq --to=Abort
args why a.sm a.ss a.rq --of=open
args why a.sm a.ss --to=Abort

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[Fill]
.step
    open = p > 775
    held(p > 825, 30 ms): -> Abort

[Abort] @abort @safe
-- a.ss --
[options]
delta_t 10
[all_states]
G == 0: p = 700
G == 20: p = 830
G == 40: p = 820
G == 200: @stop
-- a.rq --
R1 "too much pressure ends in an abort"  always p > 825 leads to S == Abort within 30 ms
-- stdout --
step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition
the script failed after this step: requirement R1 was violated
  a.sm:11: `open = p > 775` stored true: p = 820
  a.sm:12: `held(p > 825, 30 ms)` was false since step 1 (G = 0); its condition was false when the step began
where the values come from:
  a.ss:6: the script wrote p in step 5, by `p = 820`
step 21 (G = 200): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step; step 6 (G = 50) violated requirement R1
  a.sm:12: `held(p > 825, 30 ms)` was false since step 1 (G = 0); its condition was false when the step began
a.sm:12: Fill -> Abort was never taken; step 4 (G = 30) was nearest to taking it:
  a.sm:12: `held(p > 825, 30 ms)` was false since step 1 (G = 0); its condition was true since G = 20, for 10 of 30
where the values come from:
  a.ss:6: the script wrote p in step 5, by `p = 820`
step 6 (G = 50): open = true, last stored in this step
step 6 (G = 50): Fill, entered in step 1 (G = 0); took no transition
the script failed after this step: requirement R1 was violated
  a.sm:11: `p > 775` was true since step 3 (G = 20): p = 820
  a.sm:11: `open = p > 775` stored true: p = 820
what would have made a difference in this step:
  with p = 775 (it was 820), open would have become false
where the values come from:
  a.ss:6: the script wrote p in step 5, by `p = 820`
step 21 (G = 200): Fill, entered in step 1 (G = 0); took no transition
the script stopped after this step
  a.sm:12: `held(p > 825, 30 ms)` was false since step 1 (G = 0); its condition was false when the step began
a.sm:12: Fill -> Abort was never taken; step 4 (G = 30) was nearest to taking it:
  a.sm:12: `held(p > 825, 30 ms)` was false since step 1 (G = 0); its condition was true since G = 20, for 10 of 30
where the values come from:
  a.ss:6: the script wrote p in step 5, by `p = 820`
