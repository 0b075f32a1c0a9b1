# The page for a review has the table of requirements.
args report --format=text a.sm a.ss a.rq -o o.txt && sed -n "/^Requirements/,/^Findings/p" o.txt

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
# requirements
R1 "no pyro on the pad"      never S == Pad and (drogue or main)
R2 "no main before drogue"   never Main before Drogue
R3 "pressure leads to main"  always p > 100 leads to main within 100 ms
R4 "drogue stays"            always S == Main implies drogue and main
R5 "through drogue"          never Main after Pad without Drogue
-- stdout --
Requirements
------------

Each requirement is judged after every step of every script in which it could be violated. `Times`
is the number of these steps. One that was never judged has not been tested, and one that is
undecided has not been met.

  Requirement  Text                    Rule                                        Verdict
  R1           no pyro on the pad      never S == Pad and (drogue or main)         met
  R2           no main before drogue   never Main before Drogue                    met
  R3           pressure leads to main  always p > 100 leads to main within 100 ms  met
  R4           drogue stays            always S == Main implies drogue and main    met
  R5           through drogue          never Main after Pad without Drogue         met

Where each requirement is implemented and judged
  Requirement  Text                    Place   Implemented in    Tested by  Judged in  Times  Result
  R1           no pyro on the pad      a.rq:2  a.sm:9                       a.ss          31  met
  R2           no main before drogue   a.rq:3  nowhere           a.ss:5     a.ss          13  met
  R3           pressure leads to main  a.rq:4  a.sm:11, a.sm:16             a.ss          13  met
  R4           drogue stays            a.rq:5  a.sm:14                      a.ss          13  met
  R5           through drogue          a.rq:6  nowhere                      a.ss          13  met

Traceability
------------

From requirements to the machine: each mark `@req`. From the machine to requirements: a part has
those of its own marks, of the conditionals around it, and of its state; a state without a mark has
those of the marks inside it. A part without any is code that no requirement asks for, or a mark is
missing.

5 requirements: 5 tested; 1 output, 1 state without a requirement


  Requirement  Implemented in         Line
  R1           state Pad                 9
  R3           Pad -> Drogue            11
  R3           Drogue -> Main           16
  R4           Drogue: drogue = true    14

From the machine to requirements
  State   Kind        Part            Condition or statement  Line  Requirements  Marked at
  Pad     state       Pad                                        9  R1            itself
  Pad     transition  Pad -> Drogue   p > 100                   11  R3; R1        itself
  Drogue  state       Drogue                                    12  R4; R3        contents
  Drogue  output      Drogue: drogue  drogue = true             14  R4            itself
  Drogue  transition  Drogue -> Main  T > 50                    16  R3            conditional
  Main    state       Main                                      17  none
  Main    output      Main: main      main = true               19  none

From asserts to requirements
  Place   Text  Times  Result  Requirement
  a.ss:5  main      1  passed  R2

Findings
