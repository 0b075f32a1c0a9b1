# smc prove on two variables: the difference of each pair that the requirement compares is followed, with its rounding, infinities and NaN.
args prove a.sm a.rq --effort=1 | grep -v "^      "
args prove guards.sm guards.rq --effort=1 | grep "^  R"

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
R11 "rounding exceeds little more"       always S == Idle implies abs(y - prev(y)) <= 0.20000000000000012
R7 "a sum grows until 0.2 is rounded"  always S == Idle implies abs(sum - prev(sum)) <= 0.201
R9 "a NaN takes the highest back"        always S == Idle implies highest >= prev(highest)
R10 "the input of another step"        always lowest <= q
R8 "not in the first step of Moved"    always abs(y - prev(y)) <= 0.201
-- guards.sm --
[options]
step 20 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
F32  q      @read_only

[local]
F64 x = 0
F64 y = 0

[Order]
.step
    x = p
    y = q
    y < x: y = x
-- guards.rq --
R1 "in order"           always x <= y
R2 "in strict order"    always x < y
R3 "in reverse order"   always x >= y
R4 "not in reverse"     never y < x
R5 "not equal"          never x == y
R6 "never apart"        always abs(x - y) <= 1
-- stdout --
requirements of a, from state Idle, with a step every 20 ms:
  R1   proved              the highest
  R2   violated            not also if the median is NaN


  R3   proved              the lowest
  R4   proved              of all steps
  R5   proved              by 10 per second
  R6   violated            rounding exceeds 0.2


  R11  violated            rounding exceeds little more


  R7   no violation found  a sum grows until 0.2 is rounded
  R9   violated            a NaN takes the highest back


  R10  violated            the input of another step


  R8   violated            not in the first step of Moved


  R1  proved              in order
  R2  violated            in strict order
  R3  violated            in reverse order
  R4  proved              not in reverse
  R5  violated            not equal
  R6  violated            never apart
