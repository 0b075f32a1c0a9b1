# Scripts with the same file name in two folders have the end of their paths as names, in every result; other scripts have none of it.
args test v.sm a/v.ss b/v.ss one.ss v.rq | sed -n '/^requirements/,$p'
args sweep v.sm a/v.ss b/v.ss --set limit=700:900:5 | grep fails
args faults v.sm a/v.ss b/v.ss one.ss --kinds=dead | grep 'p dead'
args report v.sm a/v.ss deep/a/v.ss one.ss v.rq --format=text | sed -n '/^  Script /,/^$/p'
args test v.sm a/v.ss b/v.ss v.rq --traceability=t.csv >/dev/null; grep '^script' t.csv
args mutate v.sm a/v.ss b/v.ss --scripts=made --format=json | grep -o '"[ab]/v.ss"' | sort -u

-- v.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only @range 0 1000
bool open
[local]
F64 limit = 775 @parameter @range 500 1000
[Fill]
.step
    open = p > limit
-- v.rq --
R1 "open above 800" always p > 900 implies open
-- a/v.ss --
[all_states]
true: p = G
at 820: @assert open
at 900: @stop
-- b/v.ss --
[all_states]
true: p = G
at 740: @assert not open
at 950: @stop
-- deep/a/v.ss --
[all_states]
true: p = 10
at 740: @assert not open
at 950: @stop
-- one.ss --
[all_states]
true: p = 950
at 100: @assert open
at 100: @stop
-- stdout --
requirements:
  R1  met  open above 800
      judged in b/v.ss: 5, one.ss: 11
  700: fails: b/v.ss:3
  850 to 900: fails: a/v.ss:3
  a/v.ss:3: passes up to 819.99, fails from 820
  b/v.ss:3: passes from 740, fails up to 739.99
  now 775: below, fails at 739.99 (35.01 away, only the assert b/v.ss:3); above, fails at 820 (45 away, only the assert a/v.ss:3)
  p dead from the start, in Fill (G = 0, a/v.ss): assert at a/v.ss:3 at G = 820; open = false instead of true at G = 780; and 3 more triggers
  p dead from the start, in Fill (G = 0, b/v.ss): open = false instead of true at G = 780; and 1 more trigger
  Script       Result  Steps  Asserts passed  States visited
  a/v.ss       passed     91               1  1 of 1
  deep/a/v.ss  passed     96               1  1 of 1
  one.ss       passed     11               1  1 of 1

script,a/v.ss,,,,,,,,,passed,
script,b/v.ss,,,R1,,,,,,passed,
"a/v.ss"
"b/v.ss"
-- stderr --
smc: faults under "failed" (4) fail asserts, which describe a flight without faults: write what must hold with any fault as requirements, in a .rq file
