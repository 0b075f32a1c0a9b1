# smc prove on two variables: the difference of each pair that the requirement compares is followed, with its rounding, infinities and NaN.
args prove a.sm a.rq --effort=1 | grep -v "^      "

-- a.sm --
[options]
step 20 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F64  q      @read_only
bool go     @read_only
F64  y
F64  sum

[local]
F64 highest = 0
F64 lowest = 0
F64 other = 0

[Idle]
.step
    highest = max(highest, roll_median(p, 5))
    lowest = min(lowest, q)
    other = q
    y = clamp(y + clamp(p - y, -0.2, 0.2), -5, 5)
    sum = sum + clamp(p, -0.2, 0.2)
    go: -> Moved

[Moved]
.step
    y = y - 1
-- a.rq --
R1 "the highest"                       always S == Idle implies not (highest < roll_median(p, 5))
R2 "not also if the median is NaN"     always S == Idle implies highest >= roll_median(p, 5)
R3 "the lowest"                        always S == Idle implies lowest <= other
R4 "of all steps"                      never lowest > highest
R5 "by 10 per second"                  always S == Idle implies abs(y - prev(y)) <= 0.201
R6 "rounding exceeds 0.2"              always S == Idle implies abs(y - prev(y)) <= 0.2
R7 "a sum grows until 0.2 is rounded"  always S == Idle implies abs(sum - prev(sum)) <= 0.201
R9 "a NaN takes the highest back"        always S == Idle implies highest >= prev(highest)
R10 "the input of another step"        always lowest <= q
R8 "not in the first step of Moved"    always abs(y - prev(y)) <= 0.201
-- stdout --
requirements of a, from state Idle, with a step every 20 ms:
  R1   proved              the highest
  R2   violated            not also if the median is NaN


  R3   proved              the lowest
  R4   proved              of all steps
  R5   proved              by 10 per second
  R6   violated            rounding exceeds 0.2


  R7   no violation found  a sum grows until 0.2 is rounded
  R9   violated            a NaN takes the highest back


  R10  violated            the input of another step


  R8   violated            not in the first step of Moved
