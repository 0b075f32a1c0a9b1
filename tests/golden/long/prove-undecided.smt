# smc prove without a proof and without a violation: what was tried, which states no run came to, and what has too many values.
args prove a.sm a.rq --effort=1
args prove a.sm first.rq --effort=1 --format=json | grep -o '"obstacle".*'
args prove a.sm counts.rq --effort=1 --memory=1 | grep "^  R"
args prove a.sm a.rq --memory=0

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F64  key    @read_only
bool go     @read_only
U32  count
U32  other
bool valve

[local]
F64 a = 0
F64 b = 0

[Idle]
.step
    count = count + 1
    a = a * 31 + key * key
    a = a - 65521 * floor(a / 65521)
    b = b * 57 + key * (key + 3)
    b = b - 65521 * floor(b / 65521)
    T >= 40 ms and a == 40961 and b == 41309: -> Locked
    held(p > 5, 700 ms) and go: -> Wait
    T < 0: -> Never

[Wait]
.step
    other = other + count
    T > 7 s and go: -> Idle
    held(p < 2, 300 ms): -> Idle

[Locked]
.step
    go: -> Deep

[Deep]
.entry
    valve = true

[Never]
-- a.rq --
R1 "never open"  never valve
R3 "different"   never count == 4000000000 and other == 77 and held(p > 3, 500 ms)
-- first.rq --
R1 "never open"  never valve
-- counts.rq --
R2 "it counts"   always held(go, 900 ms) and S == Wait leads to S == Idle or p != p or go within 8 s
-- stdout --
requirements of a, from state Idle, with a step every 10 ms:
  R1  no violation found  never open
      992432 steps were tried; a proof needs too many abstract states
      no run that was tried came to Locked, Deep
      2625 abstract states and 953368 paths were examined
      too many values for a proof have: T, the samples of held(p > 5, 700 ms), the samples of held(p < 2, 300 ms)
      a proof can become possible by: a shorter timer than 7000 ms in Wait; fewer samples in held(p > 5, 700 ms); fewer samples in held(p < 2, 300 ms)
      what can help: a script that comes to these states, named in the command; @range on 'p' and 'key', with --assume-ranges; --effort=10, which searches and proves longer
  R3  no violation found  different
      992432 steps were tried; a proof needs too many abstract states
      no run that was tried came to Locked, Deep
      3901 abstract states and 1300376 paths were examined
      too many values for a proof have: count, T, the samples of held(p > 5, 700 ms), the samples of held(p < 2, 300 ms)
      a proof can become possible by: fewer values of 'count', such as a counter that stops at a limit; a shorter timer than 7000 ms in Wait; fewer samples in held(p > 5, 700 ms); fewer samples in held(p < 2, 300 ms)
      what can help: a script that comes to these states, named in the command; @range on 'p' and 'key', with --assume-ranges; --effort=10, which searches and proves longer
"obstacle":"too-large","too_many_values":["T","the samples of held(p > 5, 700 ms)","the samples of held(p < 2, 300 ms)"],"untried_states":["Locked","Deep"]}
  R2  no violation found  it counts
-- stderr --
smc: --memory requires a whole number from 1, not '0'
Try 'smc prove --help'.
-- exit --
5 0 0 2
