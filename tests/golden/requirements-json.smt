# The table of requirements as JSON.
args report --format=json a.sm a.ss a.rq -MD -o o.json && sed -n "/no pyro/p" o.json | cut -c 1-400 && cat o.d

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
      {"id": "R1", "text": "no pyro on the pad", "rule": "never S == Pad and (drogue or main)", "result": "met", "proof": "", "faults": ""},
      {"id": "R1", "text": "no pyro on the pad", "place": "a.rq:2", "implemented": "a.sm:9", "asserts": "", "scripts": "a.ss", "judged": 31, "unvisited": "", "result": "met"},
o.json: a.sm a.ss a.rq
