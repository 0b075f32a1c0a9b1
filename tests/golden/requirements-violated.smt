# A violation does not end the script: each requirement is reported for the first step that violates it, with the reason.
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
R1 "low pressure"   never S == Drogue and roll_max(p, 3 steps) > 10
R2 "main first"     never Drogue before Main
R3 "main in time"   always p > 100 leads to main within 40 ms
R4 "through main"   never Drogue after Pad without Main
R5 "main goes off"  always main leads to not main within 10 s
-- stdout --
requirements:
  R1  violated   low pressure
      judged in a.ss: 31
      implemented in a.sm:9
  R2  violated   main first
      judged in a.ss: 7
      tested by a.ss:5
      implemented nowhere
  R3  violated   main in time
      judged in a.ss: 14
      implemented in a.sm:11, a.sm:16
  R4  violated   through main
      judged in a.ss: 7
      implemented in a.sm:14
  R5  undecided  main goes off
      implemented nowhere
-- stderr --
a.rq:1:27: error: requirement R1 violated in step 12 (G = 110, state Drogue): low pressure [E1310]
    1 | R1 "low pressure"   never S == Drogue and roll_max(p, 3 steps) > 10
      |                           ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ S = Drogue, number 2, roll_max(p, 3 steps) = 200
a.ss:1:1: note: this script ran
note: the last steps, and the values after each:
      step    G  state                  S  roll_max(p, 3 steps)
         8   70  Pad        Pad, number 1                     0
         9   80  Pad        Pad, number 1                     0
        10   90  Pad        Pad, number 1                     0
        11  100  Pad        Pad, number 1                   200
        12  110  Drogue  Drogue, number 2                   200
a.sm:11:14: note: transition in step 11 (G = 100): Pad -> Drogue
note: 6 later steps violated it, too, the last of them step 18 (G = 170)
a.rq:2:27: error: requirement R2 violated in step 12 (G = 110, state Drogue): main first [E1310]
    2 | R2 "main first"     never Drogue before Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:2:41: note: no earlier step had 'Main'
note: 6 later steps violated it, too, the last of them step 18 (G = 170)
a.rq:3:45: error: requirement R3 violated in step 15 (G = 140, state Drogue): main in time [E1310]
    3 | R3 "main in time"   always p > 100 leads to main within 40 ms
      |                                             ^~~~ main = false
a.ss:1:1: note: this script ran
a.rq:3:28: note: 'p > 100' was true at G = 100, and 'main' was not true up to G = 140
note: the last steps, and the values after each:
      step    G  state    main
        11  100  Pad     false
        12  110  Drogue  false
        13  120  Drogue  false
        14  130  Drogue  false
        15  140  Drogue  false
a.sm:11:14: note: transition in step 11 (G = 100): Pad -> Drogue
note: no step has stored main
a.rq:4:27: error: requirement R4 violated in step 12 (G = 110, state Drogue): through main [E1310]
    4 | R4 "through main"   never Drogue after Pad without Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:4:52: note: the last step with 'Pad' was at G = 100, and none has had 'Main' since
note: 6 later steps violated it, too, the last of them step 18 (G = 170)
a.rq:5:1: warning: requirement R5 was undecided when the script stopped: 'main' was true at G = 180, and 'not main' has not been since [W1301 undecided-requirement]
    5 | R5 "main goes off"  always main leads to not main within 10 s
      | ^~
a.ss:1:1: note: this script ran
4 errors, 1 warning
-- exit --
1
