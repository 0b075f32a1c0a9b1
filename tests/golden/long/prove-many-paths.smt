# smc prove where a step has more paths than are kept apart, and where facts keep growing: what is then joined or widened is not lost.
args prove a.sm a.rq --effort=1 | grep "^  R"
args prove grows.sm grows.rq --effort=1 | grep "^  R"

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
bool b0     @read_only
bool b1     @read_only
bool b2     @read_only
bool b3     @read_only
bool b4     @read_only
bool b5     @read_only
bool b6     @read_only
bool b7     @read_only
U32  code

[Count]
.step
    code = 0
    b0: code = code + 1
    b1: code = code + 2
    b2: code = code + 4
    b3: code = code + 8
    b4: code = code + 16
    b5: code = code + 32
    b6: code = code + 64
    b7: code = code + 128
-- a.rq --
R1 "none"   never code == 0
R2 "all"    never code == 255
R3 "first"  never code == 1
R4 "last"   never code == 128
R5 "most"   never code > 255
-- grows.sm --
[options]
step 10 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only
bool found

[local]
F64 a = 0
F64 b = 0
F64 c = 0
F64 d = 0
F64 e = 0
F64 f = 0
F64 g = 0
F64 h = 0

[Grow]
.step
    a = a + 1
    a > 1e6: b = b + 1
    b > 1e6: c = c + 1
    c > 1e6: d = d + 1
    d > 1e6: e = e + 1
    e > 1e6: f = f + 1
    f > 1e6: g = g + 1
    g > 1e6: h = h + 1
    h > 1e6: found = true
-- grows.rq --
R1 "after years"  never found
-- stdout --
  R1  violated            none
  R2  violated            all
  R3  violated            first
  R4  violated            last
  R5  proved              most
  R1  no violation found  after years
