# smc test shows where each requirement is implemented and tested, how often it was judged, and the result.
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
# requirements
R1 "no pyro on the pad"      never S == Pad and (drogue or main)
R2 "no main before drogue"   never Main before Drogue
R3 "pressure leads to main"  always p > 100 leads to main within 100 ms
R4 "drogue stays"            always S == Main implies drogue and main
R5 "through drogue"          never Main after Pad without Drogue
-- stdout --
state script ran for 31 steps
1 assert passed
final state vector:
  G = 300
  S = 3
  T = 120
  drogue = true
  main = true
  p = 200.000000
requirements:
  R1  met  no pyro on the pad
      judged in a.ss: 31
      implemented in a.sm:9
  R2  met  no main before drogue
      judged in a.ss: 13
      tested by a.ss:5
      implemented nowhere
  R3  met  pressure leads to main
      judged in a.ss: 13
      implemented in a.sm:11, a.sm:16
  R4  met  drogue stays
      judged in a.ss: 13
      implemented in a.sm:14
  R5  met  through drogue
      judged in a.ss: 13
      implemented nowhere
