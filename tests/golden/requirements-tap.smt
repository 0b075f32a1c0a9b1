# TAP has a test for each requirement. One that is undecided is no success.
args test --tap a.sm a.ss a.rq

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
R5 "main goes off"  always main leads to not main within 10 s
R6 "on the pad"     always S == Pad implies not main
-- stdout --
TAP version 13
1..3
ok 1 - a.ss
# requirements: R2 R6
ok 2 - R5 main goes off # SKIP undecided
ok 3 - R6 on the pad
# judged in a.ss: 11
-- stderr --
a.sm:9:12: warning: no requirement has the id 'R1' [W1302 unknown-requirement]
    9 | [Pad] @req R1
      |            ^~
a.sm:11:29: warning: no requirement has the id 'R3' [W1302 unknown-requirement]
   11 |     p > 100: -> Drogue @req R3
      |                             ^~
a.sm:14:24: warning: no requirement has the id 'R4' [W1302 unknown-requirement]
   14 |     drogue = true @req R4
      |                        ^~
3 warnings
a.ss:5:5: warning: no requirement has the id 'R2' [W1302 unknown-requirement]
    5 |     @assert main @req R2
      |     ^~~~~~~~~~~~~~~~~~~~
a.rq:1:1: warning: requirement R5 was undecided when the script stopped: 'main' was true at G = 180, and 'not main' has not been since [W1301 undecided-requirement]
    1 | R5 "main goes off"  always main leads to not main within 10 s
      | ^~
a.ss:1:1: note: this script ran
2 warnings
