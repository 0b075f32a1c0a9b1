# smc mutate lists the changes that no script notices, the most dangerous first.  Changes without an effect are left out.
# The list of the first command is complete.  Of the others, only what differs from it is expected.
args mutate a.sm a.ss -v | tee all.txt; sed '/^noticed/,$d' all.txt >list.txt
args mutate a.sm a.ss --min-score=40 --format=json -o m.json && head -n 3 m.json
args mutate a.sm a.ss --min-score=100 -o m.txt; head -n 1 m.txt
args mutate a.sm a.ss --generate >found.txt; sed -n '1,3p;/^    /p' found.txt; sed '2d;/^    /d;s/; these inputs would show it//' found.txt | cmp - list.txt
args mutate a.sm a.ss bad.ss >left.txt; echo $?; grep 'Left out' left.txt; grep -v 'Left out' left.txt | cmp - list.txt
args mutate a.sm
args mutate a.sm a.ss --min-score=all
args mutate a.sm broken.ss
args mutate a.sm still.ss a.rq -v | sed -n '1,2p;/^noticed/,$p'
args mutate a.sm still.ss a.rq --format=json -o m.json; grep -c '"requirement":"R1"' m.json
args mutate a.sm still.ss never.rq >never.txt; echo $?; sed '/^not noticed/,$d' never.txt; grep '^  line' never.txt | sort >now; grep '^  line' all.txt | sed 's/ \[a.ss\]//' | sort | cmp - now
args mutate a.sm a.rq
args mutate first.sm first.ss -v --scripts=made >first.txt; sed '/^noticed/,/^no diff/d' first.txt; sed -n '/^noticed/,/^no diff/s/^  line \(.*\) \[first.ss\]$/\1/p' first.txt | sed 's/ changed to / to /;s/ in O[a-z]*//' | paste -sd ' ' - | fold -s -w 100 | sed 's/ *$//'; cat made/first-change-16-*; "$SMC" mutate first.sm first.ss made/*.ss | head -n 1

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
-- first.sm --
# The initial value of `count` is never read.  The output that Off sets is what the outside left there.
[state_vector]
U64 G
U32 S
bool go @read_only
bool heater
bool alarm

[local]
U32 count = 5
U32 seen = 0

[Off]
.entry
    heater = false
    alarm = false
    count = 0
.step
    seen = seen + 1
    go: -> On

[On]
.entry
    heater = true
    count = 0
.step
    count = count + 1
    count + seen > 6: -> Off
-- first.ss --
[options]
delta_t 10
[all_states]
G == 20: go = true
G == 50: @assert heater
G == 70 {
    @assert not heater
    @stop
}
-- broken.ss --
[options]
delta_t 10
[all_states]
G == 0: q = 1
G == 50: @stop
-- stdout --
mutations of a: 8 of 24 changes are noticed (33.3 %)
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
  line 9:34: `-` left out in Fill, an output
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
mutations of a: 8 of 24 changes are noticed (33.3 %)
mutations of a: 8 of 24 changes are noticed (33.3 %)
inputs were found for 16 of the 16 changes that no script notices; --scripts=DIR writes them as scripts
not noticed; these inputs would show it:
    from Fill, at G = 10, S differs
    from Fill, at G = 10, S differs
    from Fill, at G = 0: p = 825; at G = 10, S differs
    from Fill, at G = 0: p = 783.75; at G = 10, S differs
    from Fill, at G = 0: p = 907; at G = 10, S differs
    from Fill, at G = 10, S differs
    from Fill, at G = 10, S differs
    from Fill, at G = 10, S differs
    from Fill, at G = 0: p = 700; at G = 0, open differs
    from Fill, at G = 0: p = 631; at G = 0, open differs
    from Fill, at G = 0: p = 770; at G = 0, open differs
    from Fill, at G = 0: p = 1000; at G = 0, open differs
    from Fill, at G = 0: p = -1; at G = 0, open differs
    from Fill, at G = 0, open differs
    from Fill, at G = 0, open differs
    from Fill, at G = 0: p = -1; at G = 0, open differs
1
  Left out: bad.ss, because it fails at bad.ss:4.
mutations of a: 6 of 24 changes are noticed (25.0 %)
requirements notice 6 of them: R1 1, R2 5
noticed:
  line 10:5: `p > 825 or G < 0` changed to `1` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:7: `>` changed to `<=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:18: `<` changed to `<=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:18: `<` changed to `>=` in Fill, on the way to an @abort state [still.ss: R2]
  line 10:20: `0` changed to `1` in Fill, on the way to an @abort state [still.ss: R2]
  line 14:5: `open = true` removed in Abort, an output [still.ss: R1]
1
1
mutations of a: 0 of 24 changes are noticed (0.0 %)
  Not judged: R3 in still.ss, where it is violated anyway.
requirements notice 0 of them
mutations of first: 22 of 26 changes are noticed (84.6 %), and 3 make no difference
inputs were found for 2 of the 4 changes that no script notices
not noticed; these inputs would show it:
  line 16:5: `alarm = false` removed in Off, an output
    from Off, at G = 0: alarm = true; at G = 0, alarm differs [first-change-16-5-1.ss]
  line 20:5: `go` changed to `1` in Off
    from Off, at G = 10, S differs [first-change-16-5-1.ss]
not noticed, and no inputs were found that would show it:
  line 17:5: `count = 0` removed in Off
  line 17:13: `0` changed to `1` in Off
1 script in made shows 2 of these changes
  line 10:13: `5` changed to `4`
  line 10:13: `5` changed to `6`
  line 25:5: `count = 0` removed in On [if only inputs change]
15:5: `heater = false` removed, an output 24:5: `heater = true` removed, an output 11:12: `0` to
`1` 19:5: `seen = seen + 1` removed 19:17: `+` to `-` 19:19: `1` to `0` 19:19: `1` to `2` 20:5:
`go` to `0` 20:9: `-> On` removed 25:13: `0` to `1` 27:5: `count = count + 1` removed 27:19: `+` to
`-` 27:21: `1` to `0` 27:21: `1` to `2` 28:5: `count + seen > 6` to `0` 28:5: `count + seen > 6` to
`1` 28:11: `+` to `-` 28:18: `>` to `<=` 28:18: `>` to `>=` 28:20: `6` to `5` 28:20: `6` to `7`
28:23: `-> Off` removed
# Generated by smc mutate from first.sm (form 1, checksum 04ad22c1). A changed script is not overwritten.
# Fails if line 16 is changed: `alarm = false` removed in Off, an output.
#
# The asserts show what the machine does, not what it should do: check them before you rely on them.

[options]
delta_t    10 ms
init_state Off

[all_states]
true:     alarm = true
at 0:     @assert state Off and not heater and not alarm
at 10 ms: @assert state Off and not heater and alarm
at 10 ms: @stop
mutations of first: 24 of 27 changes are noticed (88.9 %), and 2 make no difference
-- stderr --
smc: the scripts notice 33.3 % of the changes, and 40 % are required
smc: the scripts notice 33.3 % of the changes, and 100 % are required
smc: scripts that do not pass without any change: 1 of 2; what they cannot show is left out ('smc test' shows why)
smc: a script is required that could notice changes, as in 'smc mutate a.sm SCRIPT.ss'
Try 'smc mutate --help'.
smc: --min-score requires a percentage from 0 to 100, not 'all'
Try 'smc mutate --help'.
broken.ss:4:9: error: unknown element 'q' [E0204]
    4 | G == 0: q = 1
      |         ^
1 error
smc: scripts that do not pass without any change: 1 of 1; what they cannot show is left out ('smc test' shows why)
smc: a script is required that could notice changes, as in 'smc mutate a.sm SCRIPT.ss'
Try 'smc mutate --help'.
-- exit --
0 1 0 0 0 2 2 1 0 0 0 2 0
