# smc mutate lists the changes that no script notices, the most dangerous first.  Changes without an effect are left out.
args mutate a.sm a.ss -v
args mutate a.sm a.ss --min-score=40 --format=json -o m.json && head -n 3 m.json
args mutate a.sm a.ss --min-score=100 -o m.txt; head -n 1 m.txt
args mutate a.sm a.ss --generate
args mutate a.sm a.ss bad.ss
args mutate a.sm
args mutate a.sm a.ss --min-score=all
args mutate a.sm broken.ss
args mutate a.sm still.ss a.rq -v | sed -n '1,2p;/^noticed/,$p'
args mutate a.sm still.ss a.rq --format=json -o m.json; grep -c '"requirement":"R1"' m.json
args mutate a.sm still.ss never.rq
args mutate a.sm a.rq

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[Fill]
.step
    open = not (p > 700) and p > -1
    p > 825 or G < 0: -> Abort

[Abort] @abort @safe
.entry
    open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 10
G == 10: @assert open
G == 30: p = 1000
G == 50 {
    @assert open
    @stop
}
-- bad.ss --
[options]
delta_t 10
[all_states]
true: @assert not open
G == 50: @stop
-- still.ss --
[options]
delta_t 10
[all_states]
G == 30: p = 1000
G == 50 {
    @assert p == 1000
    @stop
}
-- a.rq --
R1 "open at a high pressure"   always S == Abort and p > 850 leads to open within 10
R2 "no abort at a low one"     never  S == Abort and p < 800
-- never.rq --
R3 "never an abort"            never  S == Abort
-- broken.ss --
[options]
delta_t 10
[all_states]
G == 0: q = 1
G == 50: @stop
-- stdout --
mutations of a: 8 of 23 changes are noticed (34.8 %)
not noticed:
  line 10:5: `p > 825 or G < 0` changed to `1` in Fill, on the way to an @abort state
  line 10:7: `>` changed to `<=` in Fill, on the way to an @abort state
  line 10:7: `>` changed to `>=` in Fill, on the way to an @abort state
  line 10:9: `825` changed to `743` in Fill, on the way to an @abort state
  line 10:9: `825` changed to `907` in Fill, on the way to an @abort state
  line 10:18: `<` changed to `<=` in Fill, on the way to an @abort state
  line 10:18: `<` changed to `>=` in Fill, on the way to an @abort state
  line 10:20: `0` changed to `1` in Fill, on the way to an @abort state
  line 9:19: `>` changed to `>=` in Fill, an output
  line 9:21: `700` changed to `630` in Fill, an output
  line 9:21: `700` changed to `770` in Fill, an output
  line 9:26: `and` changed to `or` in Fill, an output
  line 9:32: `>` changed to `>=` in Fill, an output
  line 9:35: `1` changed to `0` in Fill, an output
  line 9:35: `1` changed to `2` in Fill, an output
noticed:
  line 10:5: `p > 825 or G < 0` changed to `0` in Fill, on the way to an @abort state [a.ss]
  line 10:13: `or` changed to `and` in Fill, on the way to an @abort state [a.ss]
  line 10:23: `-> Abort` removed in Fill, on the way to an @abort state [a.ss]
  line 9:5: `open = not (p > 700) and p > -1` removed in Fill, an output [a.ss]
  line 9:12: `not` left out in Fill, an output [a.ss]
  line 9:19: `>` changed to `<=` in Fill, an output [a.ss]
  line 9:32: `>` changed to `<=` in Fill, an output [a.ss]
  line 14:5: `open = true` removed in Abort, an output [a.ss]
mutations of a: 8 of 23 changes are noticed (34.8 %)
mutations of a: 8 of 23 changes are noticed (34.8 %)
not noticed; these inputs would show it:
  line 10:5: `p > 825 or G < 0` changed to `1` in Fill, on the way to an @abort state
    from Fill, at G = 10, S differs
  line 10:7: `>` changed to `<=` in Fill, on the way to an @abort state
    from Fill, at G = 10, S differs
  line 10:7: `>` changed to `>=` in Fill, on the way to an @abort state
    from Fill, at G = 0: p = 825; at G = 10, S differs
  line 10:9: `825` changed to `743` in Fill, on the way to an @abort state
    from Fill, at G = 0: p = 825; at G = 10, S differs
  line 10:9: `825` changed to `907` in Fill, on the way to an @abort state
    from Fill, at G = 0: p = 825.825; at G = 10, S differs
  line 10:18: `<` changed to `<=` in Fill, on the way to an @abort state
    from Fill, at G = 10, S differs
  line 10:18: `<` changed to `>=` in Fill, on the way to an @abort state
    from Fill, at G = 10, S differs
  line 10:20: `0` changed to `1` in Fill, on the way to an @abort state
    from Fill, at G = 10, S differs
  line 9:19: `>` changed to `>=` in Fill, an output
    from Fill, at G = 0: p = 700; at G = 0, open differs
  line 9:21: `700` changed to `630` in Fill, an output
    from Fill, at G = 0: p = 699.3; at G = 0, open differs
  line 9:21: `700` changed to `770` in Fill, an output
    from Fill, at G = 0: p = 735; at G = 0, open differs
  line 9:26: `and` changed to `or` in Fill, an output
    from Fill, at G = 0: p = 1000; at G = 0, open differs
  line 9:32: `>` changed to `>=` in Fill, an output
    from Fill, at G = 0: p = -1; at G = 0, open differs
  line 9:35: `1` changed to `0` in Fill, an output
    from Fill, at G = 0, open differs
  line 9:35: `1` changed to `2` in Fill, an output
    from Fill, at G = 0: p = -1.05; at G = 0, open differs
mutations of a: 6 of 23 changes are noticed (26.1 %)
requirements notice 6 of them: R1 1, R2 5
noticed:
  line 10:5: `p > 825 or G < 0` changed to `1` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:7: `>` changed to `<=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:18: `<` changed to `<=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:18: `<` changed to `>=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:20: `0` changed to `1` in Fill, on the way to an @abort state [still.ss: R2]
  line 14:5: `open = true` removed in Abort, an output [still.ss: R1]
1
-- stderr --
smc: the scripts notice 34.8 % of the changes, and 40 % are required
smc: the scripts notice 34.8 % of the changes, and 100 % are required
smc: bad.ss fails without any change: 'smc test' shows why
smc: a script is required that could notice changes, as in 'smc mutate a.sm SCRIPT.ss'
Try 'smc mutate --help'.
smc: --min-score requires a percentage from 0 to 100, not 'all'
Try 'smc mutate --help'.
broken.ss:4:9: error: unknown element 'q' [E0204]
    4 | G == 0: q = 1
      |         ^
1 error
smc: still.ss fails without any change: 'smc test' shows why
smc: a script is required that could notice changes, as in 'smc mutate a.sm SCRIPT.ss'
Try 'smc mutate --help'.
-- exit --
0 1 0 0 1 2 2 1 0 0 1 2
