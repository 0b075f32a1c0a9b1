# A script that fails anyway is left out, and a requirement is not judged in the scripts that violate it anyway: text, JSON and page name them.
args faults a.sm bad.ss high.ss low.ss a.rq --kinds=dead | head -n 5
args faults a.sm bad.ss high.ss low.ss a.rq --kinds=dead --format=json 2>/dev/null | grep -o '"left_out.*'
args mutate a.sm bad.ss high.ss low.ss a.rq 2>/dev/null | head -n 5
args mutate a.sm bad.ss high.ss low.ss a.rq --format=json | head -n 1 | grep -o '"left_out.*'
args report a.sm bad.ss high.ss low.ss a.rq --faults --mutate --sweep --format=text 2>/dev/null | grep -A1 "Left out\|Not judged\|anyway"
args faults a.sm bad.ss a.rq

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 time @alias G
U32 state @alias S
F64 p @read_only @range 0 1000
bool valve
[local]
F64 most = 825 @parameter @range 700 900
[Fill]
.step
    valve = p > 100
    p > most: -> Vent
[Vent] @safe
.step
    valve = true
-- bad.ss --
[all_states]
at 0: p = 50
at 30 ms: @assert valve
at 100 ms: @stop
-- high.ss --
[all_states]
at 0: p = 50
at 20 ms: p = 900
at 60 ms: @assert state Vent
at 100 ms: @stop
-- low.ss --
[all_states]
at 0: p = 50
at 100 ms: @stop
-- a.rq --
R1 "open at once"     always p > 800 implies S == Vent
R2 "open if too high" always p > 200 leads to valve within 20 ms
-- stdout --
faults of a: 1 input, 6 triggers in 2 scripts; 2 of 6 faults have an effect
  Left out: bad.ss, because it fails at bad.ss:3.
  Not judged: R1 in high.ss, where it is violated anyway.
input  dead
p      R2
"left_out":[{"script":"bad.ss","why":"fails at bad.ss:3"}],"not_judged":[{"requirement":"R1","script":"high.ss"}],
mutations of a: 3 of 13 changes are noticed (23.1 %)
  Left out: bad.ss, because it fails at bad.ss:3.
  Not judged: R1 in high.ss, where it is violated anyway.
requirements notice 0 of them
not noticed:
"left_out":[{"script":"bad.ss","why":"fails at bad.ss:3"}],"not_judged":[{"requirement":"R1","script":"high.ss"}],"mutants":[
  Changes that scripts notice  open     23.1 % of 13; without what fails anyway
  Faults of sensors            failed   of input and kind: 7 violated, 3 without effect; without what fails anyway
  Parameters                   open     1 with a known margin; without what fails anyway
  Longest step                          8 instructions, in Fill
--
Left out: bad.ss, because it fails at bad.ss:3.

Not judged: R1 in high.ss, where it is violated anyway.

--
Left out: bad.ss, because it fails at bad.ss:3.

Not judged: R1 in high.ss, where it is violated anyway.

--
Left out: bad.ss, because it fails at bad.ss:3.

Not judged: R1 in high.ss, where it is violated anyway.
-- stderr --
smc: scripts that do not pass without any fault: 2 of 3; what they cannot show is left out ('smc test' shows why)
smc: scripts that do not pass without any change: 2 of 3; what they cannot show is left out ('smc test' shows why)
smc: bad.ss fails at bad.ss:3 without any fault, and no other script is left: correct it or the machine ('smc test' shows why), or name a script that passes
-- exit --
0 0 0 0 0 1
