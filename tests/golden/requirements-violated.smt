# A violation ends the script; all requirements that the step violates are reported, with the reason.
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
  R1  violated      low pressure
      judged in a.ss: 12
      implemented in a.sm:9
  R2  violated      main first
      judged in a.ss: 1
      no script came to Main
      implemented nowhere
  R3  undecided     main in time
      implemented in a.sm:11, a.sm:16
  R4  violated      through main
      judged in a.ss: 1
      no script came to Main
      implemented in a.sm:14
  R5  never judged  main goes off
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
a.rq:2:27: error: requirement R2 violated in step 12 (G = 110, state Drogue): main first [E1310]
    2 | R2 "main first"     never Drogue before Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:2:41: note: no earlier step had 'Main'
a.rq:4:27: error: requirement R4 violated in step 12 (G = 110, state Drogue): through main [E1310]
    4 | R4 "through main"   never Drogue after Pad without Main
      |                           ^~~~~~
a.ss:1:1: note: this script ran
a.rq:4:52: note: the last step with 'Pad' was at G = 100, and none has had 'Main' since
3 errors
-- exit --
1
