# An assert that is true whatever the machine does: by itself, or by the types of what it compares. One that can fail has no warning.
args test a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
U16 count
F32 p
bool open
[Idle]
.step
    count > 9 and p > 5: open = true
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10 {
    @expect open != 2 within 10
    @assert open or not open
    @assert count >= 0
    @assert p > 5 or p <= 5
    @assert count == count
    @assert open < 2 "bool"
    @assert 0 <= count <= 65535
    @assert not (open and not open)
    @assert count >= 0 or open
    @assert count != 70000 and not (open == 2)
}
G == 20 {
    @assert not open
    @assert count >= 0 and count <= 100
    @assert 0 <= count <= 100
    @assert open or p <= 5
    @assert p > 5 or p < 5
    @assert p > 5 or count <= 5
    @stop
}
-- stdout --
state script ran for 3 steps
16 asserts passed
final state vector:
  G = 20
  S = 1
  T = 20
  count = 0
  open = false
  p = 0.000000
-- stderr --
a.ss:5:13: warning: this condition cannot be false here [W0752 decided-assert]
    5 |     @expect open != 2 within 10
      |             ^~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:6:13: warning: this condition cannot be false here [W0752 decided-assert]
    6 |     @assert open or not open
      |             ^~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:7:13: warning: this condition cannot be false here [W0752 decided-assert]
    7 |     @assert count >= 0
      |             ^~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:8:13: warning: this condition cannot be false here [W0752 decided-assert]
    8 |     @assert p > 5 or p <= 5
      |             ^~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:9:13: warning: this condition cannot be false here [W0752 decided-assert]
    9 |     @assert count == count
      |             ^~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:10:13: warning: this condition cannot be false here [W0752 decided-assert]
   10 |     @assert open < 2 "bool"
      |             ^~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:11:13: warning: this condition cannot be false here [W0752 decided-assert]
   11 |     @assert 0 <= count <= 65535
      |             ^~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:12:13: warning: this condition cannot be false here [W0752 decided-assert]
   12 |     @assert not (open and not open)
      |             ^~~~~~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:13:13: warning: this condition cannot be false here [W0752 decided-assert]
   13 |     @assert count >= 0 or open
      |             ^~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:14:13: warning: this condition cannot be false here [W0752 decided-assert]
   14 |     @assert count != 70000 and not (open == 2)
      |             ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
10 warnings
-- exit --
0
