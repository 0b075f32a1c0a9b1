# smc prove on windows of different sizes with the same samples: where the requirement compares three samples, it is known what the machine has found of two.
args prove a.sm a.rq --effort=1 | grep "^  R"

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F32  a      @read_only
F32  b      @read_only
F32  c      @read_only
F32  level

[define]
pressure = max(min(a, b), min(max(a, b), c))

[Start]
.step
    roll_min(pressure, 2) > 28: -> Abort
    roll_max(pressure, 4) < 14: -> Abort
    T > 100 ms: -> Burn

[Burn]
.step
    roll_min(pressure, 2) > 28: -> Abort
    roll_max(pressure, 4) < 14: -> Abort
    roll_min(level, 2) > 28: -> Abort
    level = a

[Abort]
-- a.rq --
R1 "never three samples above"  never S == Burn and roll_min(pressure, 3) > 28
R2 "two samples above"          never S == Burn and roll_min(pressure, 2) > 28
R3 "never six samples below"    never S == Burn and roll_max(pressure, 6) < 14
R5 "the level changes in the step"  never S == Burn and roll_min(level, 3) > 28
R4 "four samples below"         never S == Burn and roll_max(pressure, 4) < 14
-- stdout --
  R1  proved              never three samples above
  R2  violated            two samples above
  R3  proved              never six samples below
  R5  violated            the level changes in the step
  R4  violated            four samples below
