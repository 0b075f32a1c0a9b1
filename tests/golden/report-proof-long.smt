# A violating script of many lines is shown shortened, with what prints all of it.
args report a.sm a.rq --prove --format=text -o o.txt || sed -n "/^Proofs/,/^Traceability/p" o.txt

-- a.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F32 p0 @read_only @range 0 100
F32 p1 @read_only @range 0 100
F32 p2 @read_only @range 0 100
F32 p3 @read_only @range 0 100
F32 p4 @read_only @range 0 100
F32 p5 @read_only @range 0 100
F32 p6 @read_only @range 0 100
F32 p7 @read_only @range 0 100
F32 p8 @read_only @range 0 100
F32 p9 @read_only @range 0 100
F32 p10 @read_only @range 0 100
F32 p11 @read_only @range 0 100
F32 p12 @read_only @range 0 100
F32 p13 @read_only @range 0 100
F32 p14 @read_only @range 0 100
F32 p15 @read_only @range 0 100
F32 p16 @read_only @range 0 100
F32 p17 @read_only @range 0 100
F32 p18 @read_only @range 0 100
F32 p19 @read_only @range 0 100
F32 p20 @read_only @range 0 100
F32 p21 @read_only @range 0 100
F32 p22 @read_only @range 0 100
F32 p23 @read_only @range 0 100
F32 p24 @read_only @range 0 100
F32 p25 @read_only @range 0 100
F32 p26 @read_only @range 0 100
F32 p27 @read_only @range 0 100
F32 p28 @read_only @range 0 100
F32 p29 @read_only @range 0 100
F32 p30 @read_only @range 0 100
F32 p31 @read_only @range 0 100
F32 p32 @read_only @range 0 100
F32 p33 @read_only @range 0 100
F32 p34 @read_only @range 0 100
F32 p35 @read_only @range 0 100
F32 p36 @read_only @range 0 100
F32 p37 @read_only @range 0 100
F32 p38 @read_only @range 0 100
F32 p39 @read_only @range 0 100
bool open
[A0]
.step
    p0 > 20: -> A1
[A1]
.step
    p1 > 21: -> A2
[A2]
.step
    p2 > 22: -> A3
[A3]
.step
    p3 > 23: -> A4
[A4]
.step
    p4 > 24: -> A5
[A5]
.step
    p5 > 25: -> A6
[A6]
.step
    p6 > 26: -> A7
[A7]
.step
    p7 > 27: -> A8
[A8]
.step
    p8 > 28: -> A9
[A9]
.step
    p9 > 29: -> A10
[A10]
.step
    p10 > 30: -> A11
[A11]
.step
    p11 > 31: -> A12
[A12]
.step
    p12 > 32: -> A13
[A13]
.step
    p13 > 33: -> A14
[A14]
.step
    p14 > 34: -> A15
[A15]
.step
    p15 > 35: -> A16
[A16]
.step
    p16 > 36: -> A17
[A17]
.step
    p17 > 37: -> A18
[A18]
.step
    p18 > 38: -> A19
[A19]
.step
    p19 > 39: -> A20
[A20]
.step
    p20 > 40: -> A21
[A21]
.step
    p21 > 41: -> A22
[A22]
.step
    p22 > 42: -> A23
[A23]
.step
    p23 > 43: -> A24
[A24]
.step
    p24 > 44: -> A25
[A25]
.step
    p25 > 45: -> A26
[A26]
.step
    p26 > 46: -> A27
[A27]
.step
    p27 > 47: -> A28
[A28]
.step
    p28 > 48: -> A29
[A29]
.step
    p29 > 49: -> A30
[A30]
.step
    p30 > 50: -> A31
[A31]
.step
    p31 > 51: -> A32
[A32]
.step
    p32 > 52: -> A33
[A33]
.step
    p33 > 53: -> A34
[A34]
.step
    p34 > 54: -> A35
[A35]
.step
    p35 > 55: -> A36
[A36]
.step
    p36 > 56: -> A37
[A37]
.step
    p37 > 57: -> A38
[A38]
.step
    p38 > 58: -> A39
[A39]
.step
    p39 > 59: -> Open
[Open]
.entry
    open = true
-- a.rq --
R1 "never open"        never open
-- stdout --
Proofs
------

`smc prove` decides whether any run can violate a requirement. A proof holds for all inputs, NaN
and infinities included, with the machine's step and the assumptions named. The lines after a proof
are what is true after each step in a state. A script shows a violation. Without a proof and
without a violation, the requirement is only as good as its tests.

R1: never open [violated]
  after 41 steps
  # Violates R1 (never open).

  [options]
  delta_t    10 ms
  init_state A0

  [all_states]
  at 0 {
      p0 = 100
      p1 = 22
      p2 = 100
      p3 = 100
      p4 = 50
      p5 = 100
      p6 = 50
      p7 = 100
      p8 = 100
      p9 = 50
      p10 = 100
      p11 = 100
      p12 = 100
      p13 = 100
      p14 = 100
      p15 = 100
      p16 = 100
      p17 = 100
      p18 = 100
      p19 = 100
      p20 = 50
      p21 = 100
      p22 = 50
      p23 = 100
      p24 = 100
      p25 = 100
      p26 = 100
      p27 = 100
      p28 = 100
      p29 = 100
      p30 = 100

24 more lines. `smc prove` with the same files prints the whole script; save it as a `.ss` and run
it with `smc test`.

Traceability
