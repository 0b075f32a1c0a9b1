# smc fix puts operands in parentheses.
args fix a.sm a.rq && cat a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only
bool drogue
bool main
[Pad] @req R1
.step
    p > 100: -> Drogue @req R3
[Drogue]
.entry
    drogue = true @req R4
.step
    if T > 50 { -> Main } @req R3
[Main] @safe
.entry
    main = true
-- a.rq --
R1 "a" never main before drogue
R2 "b" never p > 5 before Drogue
-- stdout --
a.rq:1:
  - R1 "a" never main before drogue
  - R2 "b" never p > 5 before Drogue
  + R1 "a" never (main) before (drogue)
  + R2 "b" never (p > 5) before Drogue
a.rq: 3 fixed
R1 "a" never (main) before (drogue)
R2 "b" never (p > 5) before Drogue
-- stderr --
a.sm:11:29: warning: no requirement has the id 'R3' [W1302 unknown-requirement]
   11 |     p > 100: -> Drogue @req R3
      |                             ^~
a.sm:14:24: warning: no requirement has the id 'R4' [W1302 unknown-requirement]
   14 |     drogue = true @req R4
      |                        ^~
2 warnings
