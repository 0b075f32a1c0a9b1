# An assert that follows from a guard around it, or from an input that its body sets. One about what the machine writes, or about an input that a
# later line of the script may set in the same step, can fail. Requirements that a premise or a type decides.
args test a.sm a.ss
args test a.sm b.ss a.rq
args test a.sm a.ss c.rq 2>&1 | grep W1304

-- a.sm --
[state_vector]
U64  G
U32  S
F32  p  @read_only
F32  q  @read_only
U8   u  @read_only
U16  count
bool open
[define]
high = p > 60
[Idle]
.step
    p + q + u > 80 and high: open = true
    open: count = count + 1
    p > 900: -> On
[On]
.step
    p < 2: -> Idle
-- a.ss --
[options]
delta_t 10
[local]
F32 w = 0
[all_states]
T > 20: @assert G > 0
T > 20: @assert 20 <= G
T > 20: @assert T > 10 and count >= 0 and open == open or count < 9
G > 20 and T >= 0: @assert G > 20
at 100: @assert G > 0
at 100: @assert G == 100
from 20 to 50: @assert G >= 20
at 60 {
    p = 70
    u = 300
    @assert p == 70
    @assert u == 255
    @assert p * 2 > 100 and open
    @assert high and p * 2 > 100
    open: @assert p > 60
    p > 60: @assert p > 50
}
at 70 {
    w = 3
    w > 2: @assert w > 1
}
at 80 {
    p = 3
    p = 71
    @assert p > 60
    @assert not (open and count < 0)
}
S == On: @assert S != Idle
at 100: @stop
-- b.ss --
[options]
delta_t 10
[all_states]
T > 20: @assert G > 25
T > 20: @assert T > 10 and count < 9
G > 20: @assert T > 20
G > 20: @assert G < 900
at 60 {
    p = 70
    q = 5
    @assert q == 5 or q == 1
    @assert p < 99 and not open or open
    p > 60: @assert q < 7
}
at 60 {
    q = 6
    p = 71
}
at 70: q = 5
open: @assert count > 0
else: @assert not open
count < 99: @assert count < 99
p > 2 {
    p = 1
    @assert p < 2
    p < 2: @assert open or p < 2
}
G < 900: q = 1
else: @assert G < 900
at 90: p = 3
at 100: @stop
-- a.rq --
A1 "a" always count >= 0
A2 "b" never p > 5 and p < 3
A3 "c" always p > 6 implies p > 5
A4 "d" always p > 6 leads to open or p > 5 within 1 s
A5 "e" never (count < 0) after On without Idle
A7 "g" never (u > 300) before On
B1 "h" always p > 6 implies p > 7 or not open
B2 "i" always prev(p) > 6 implies p > 5 or p <= 7
B3 "j" always p > 6 leads to p > 7 or G > 0 within 1 s
-- c.rq --
C1 "never met" never count >= 0
-- stdout --
state script ran for 11 steps
45 asserts passed
final state vector:
  G = 100
  S = 1
  T = 100
  count = 5
  open = true
  p = 71.000000
  q = 0.000000
  u = 255
state script ran for 11 steps
61 asserts passed
final state vector:
  G = 100
  S = 1
  T = 100
  count = 0
  open = false
  p = 1.000000
  q = 1.000000
  u = 0
requirements:
  A1  met           a
      judged in b.ss: 11
  A2  met           b
      judged in b.ss: 11
  A3  never judged  c
  A4  never judged  d
  A5  never judged  e
      no script came to On
  A7  never judged  g
      no script came to On
  B1  never judged  h
  B2  never judged  i
  B3  never judged  j
c.rq:1:1: warning: requirement C1 is violated in every step, whatever the machine does [W1304 decided-requirement]
-- stderr --
a.ss:6:17: warning: this condition cannot be false here [W0752 decided-assert]
    6 | T > 20: @assert G > 0
      |                 ^~~~~ it is true whatever the machine does, so it tests nothing
a.ss:7:17: warning: this condition cannot be false here [W0752 decided-assert]
    7 | T > 20: @assert 20 <= G
      |                 ^~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:8:17: warning: this condition cannot be false here [W0752 decided-assert]
    8 | T > 20: @assert T > 10 and count >= 0 and open == open or count < 9
      |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:9:28: warning: this condition cannot be false here [W0752 decided-assert]
    9 | G > 20 and T >= 0: @assert G > 20
      |                            ^~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:10:17: warning: this condition cannot be false here [W0752 decided-assert]
   10 | at 100: @assert G > 0
      |                 ^~~~~ it is true whatever the machine does, so it tests nothing
a.ss:11:17: warning: this condition cannot be false here [W0752 decided-assert]
   11 | at 100: @assert G == 100
      |                 ^~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:12:24: warning: this condition cannot be false here [W0752 decided-assert]
   12 | from 20 to 50: @assert G >= 20
      |                        ^~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:16:13: warning: this condition cannot be false here [W0752 decided-assert]
   16 |     @assert p == 70
      |             ^~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:17:13: warning: this condition cannot be false here [W0752 decided-assert]
   17 |     @assert u == 255
      |             ^~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:19:13: warning: this condition cannot be false here [W0752 decided-assert]
   19 |     @assert high and p * 2 > 100
      |             ^~~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:20:19: warning: this assert was never evaluated [W0750 unjudged-assert]
   20 |     open: @assert p > 60
      |                   ^~~~~~ its condition was never true
a.ss:21:21: warning: this condition cannot be false here [W0752 decided-assert]
   21 |     p > 60: @assert p > 50
      |                     ^~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:25:20: warning: this condition cannot be false here [W0752 decided-assert]
   25 |     w > 2: @assert w > 1
      |                    ^~~~~ it is true whatever the machine does, so it tests nothing
a.ss:30:13: warning: this condition cannot be false here [W0752 decided-assert]
   30 |     @assert p > 60
      |             ^~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:31:13: warning: this condition cannot be false here [W0752 decided-assert]
   31 |     @assert not (open and count < 0)
      |             ^~~~~~~~~~~~~~~~~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:33:18: warning: this condition cannot be false here [W0752 decided-assert]
   33 | S == On: @assert S != Idle
      |                  ^~~~~~~~~ it is true whatever the machine does, so it tests nothing
a.ss:33:18: warning: this assert was never evaluated [W0750 unjudged-assert]
   33 | S == On: @assert S != Idle
      |                  ^~~~~~~~~ its condition was never true
17 warnings
a.rq:1:1: warning: requirement A1 is never violated, whatever the machine does [W1304 decided-requirement]
    1 | A1 "a" always count >= 0
      | ^~
a.rq:2:1: warning: requirement A2 is never violated, whatever the machine does [W1304 decided-requirement]
    2 | A2 "b" never p > 5 and p < 3
      | ^~
a.rq:3:1: warning: requirement A3 is never violated, whatever the machine does [W1304 decided-requirement]
    3 | A3 "c" always p > 6 implies p > 5
      | ^~
a.rq:4:1: warning: requirement A4 is never violated, whatever the machine does [W1304 decided-requirement]
    4 | A4 "d" always p > 6 leads to open or p > 5 within 1 s
      | ^~
a.rq:5:1: warning: requirement A5 is never violated, whatever the machine does [W1304 decided-requirement]
    5 | A5 "e" never (count < 0) after On without Idle
      | ^~
a.rq:6:1: warning: requirement A7 is never violated, whatever the machine does [W1304 decided-requirement]
    6 | A7 "g" never (u > 300) before On
      | ^~
a.rq:8:1: warning: requirement B2 is never violated, whatever the machine does [W1304 decided-requirement]
    8 | B2 "i" always prev(p) > 6 implies p > 5 or p <= 7
      | ^~
7 warnings
b.ss:20:15: warning: this assert was never evaluated [W0750 unjudged-assert]
   20 | open: @assert count > 0
      |               ^~~~~~~~~ its condition was never true
b.ss:29:15: warning: this assert was never evaluated [W0750 unjudged-assert]
   29 | else: @assert G < 900
      |               ^~~~~~~ its condition was never true
2 warnings
a.rq:3:1: warning: requirement A3 was never judged: c [W1300 unjudged-requirement]
    3 | A3 "c" always p > 6 implies p > 5
      | ^~
a.rq:4:1: warning: requirement A4 was never judged: d [W1300 unjudged-requirement]
    4 | A4 "d" always p > 6 leads to open or p > 5 within 1 s
      | ^~
a.rq:5:1: warning: requirement A5 was never judged: e [W1300 unjudged-requirement]
    5 | A5 "e" never (count < 0) after On without Idle
      | ^~
a.rq:6:1: warning: requirement A7 was never judged: g [W1300 unjudged-requirement]
    6 | A7 "g" never (u > 300) before On
      | ^~
a.rq:7:1: warning: requirement B1 was never judged: h [W1300 unjudged-requirement]
    7 | B1 "h" always p > 6 implies p > 7 or not open
      | ^~
a.rq:8:1: warning: requirement B2 was never judged: i [W1300 unjudged-requirement]
    8 | B2 "i" always prev(p) > 6 implies p > 5 or p <= 7
      | ^~
a.rq:9:1: warning: requirement B3 was never judged: j [W1300 unjudged-requirement]
    9 | B3 "j" always p > 6 leads to p > 7 or G > 0 within 1 s
      | ^~
7 warnings
