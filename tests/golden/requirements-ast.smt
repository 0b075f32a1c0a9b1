# The trees of requirements and marks.
args build --emit=ast a.rq
args build --emit=ast a.sm

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
R6 "more" always (main implies p > 1) and held(main implies drogue, 30 ms)
-- stdout --
# Syntax tree of a.rq, printed by smc
R1 "no pyro on the pad" never ((S == Pad) and (paren (drogue or main)))
R2 "no main before drogue" never Main before Drogue
R3 "pressure leads to main" always (p > 100) leads to main within 100 ms
R4 "drogue stays" always ((S == Main) implies (drogue and main))
R5 "through drogue" never Main after Pad without Drogue
R6 "more" always ((paren (main implies (p > 1))) and held((main implies drogue), 30 ms))
# Syntax tree of a.sm, printed by smc
options options
  step 10 ms
state_vector state_vector
  U64 time @alias G
  U32 state @alias S
  F64 p @read_only
  bool drogue
  bool main
state Pad @req R1
  .step
    if (p > 100) :
      -> Drogue @req R3
state Drogue
  .entry
    drogue = true @req R4
  .step
    if (T > 50) {} @req R3
      -> Main
state Main @safe
  .entry
    main = true
