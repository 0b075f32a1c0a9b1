# A leads to that is too late, beside one that was never judged.
args test a.sm a.ss a.rq

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
-- a.ss --
[all_states]
G == 0: p = 0
G == 100: p = 200
G == 300 {
    @assert main @req R2
    @stop
}
-- a.rq --
R3 "main in time"   always p > 100 leads to main within 40 ms
R5 "never there"    always p < 0 implies main
-- stdout --
requirements:
  R3  violated      main in time
      judged in a.ss: 14
      implemented in a.sm:11, a.sm:16
  R5  never judged  never there
      implemented nowhere
-- stderr --
a.sm:9:12: warning: no requirement has the id 'R1' [W1302 unknown-requirement]
    9 | [Pad] @req R1
      |            ^~
a.sm:14:24: warning: no requirement has the id 'R4' [W1302 unknown-requirement]
   14 |     drogue = true @req R4
      |                        ^~
2 warnings
a.ss:5:5: warning: no requirement has the id 'R2' [W1302 unknown-requirement]
    5 |     @assert main @req R2
      |     ^~~~~~~~~~~~~~~~~~~~
a.rq:1:45: error: requirement R3 violated in step 15 (G = 140, state Drogue): main in time [E1310]
    1 | R3 "main in time"   always p > 100 leads to main within 40 ms
      |                                             ^~~~ main = false
a.ss:1:1: note: this script ran
a.rq:1:28: note: 'p > 100' was true at G = 100, and 'main' was not true up to G = 140
note: the last steps, and the values after each:
      step    G  state    main
        11  100  Pad     false
        12  110  Drogue  false
        13  120  Drogue  false
        14  130  Drogue  false
        15  140  Drogue  false
a.sm:11:14: note: transition in step 11 (G = 100): Pad -> Drogue
note: no step has stored main
1 error, 1 warning
a.rq:2:1: warning: requirement R5 was never judged: never there [W1300 unjudged-requirement]
    2 | R5 "never there"    always p < 0 implies main
      | ^~
1 warning
-- exit --
1
