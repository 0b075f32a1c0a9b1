# An assert that a state's section makes true: it is judged only in that state. In [all_states], and of another state, it can fail.
args test a.sm a.ss
args test -Werror a.app b.ss

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    T >= 50: -> Open
[Open] @safe
.entry
    open = true
-- a.ss --
[options]
delta_t 10
[Idle]
T < 50: @assert S == Idle
T < 50: @assert state Idle
T < 50: @assert Open != S
T < 50: @assert not open and S == Idle
[Open]
T < 50 {
    @assert S != Idle "open for 50 ms"
    @assert open
}
[all_states]
G == 100 {
    @assert state Open
    @stop
}
-- a.sv --
[state_vector]
U64  time
U32  one
U32  two
bool openA
bool openB
-- a.app --
[options]
state_vector "a.sv"
time time 1 ms
[both]
every 10 ms:
    machine first  "a.sm" { G = time  S = one  open = openA }
    machine second "a.sm" { G = time  S = two  open = openB }
-- b.ss --
[second.Open]
true {
    @assert second.S == Open
    @assert first.S == Open
}
[all_states]
G == 100: @stop
-- stdout --
state script ran for 11 steps
31 asserts passed
final state vector:
  G = 100
  S = 2
  T = 40
  open = true
-- stderr --
a.ss:4:17: warning: this condition cannot be false here [W0752 decided-assert]
    4 | T < 50: @assert S == Idle
      |                 ^~~~~~~~~ it is judged only while the machine is in 'Idle'
a.ss:5:17: warning: this condition cannot be false here [W0752 decided-assert]
    5 | T < 50: @assert state Idle
      |                 ^~~~~~~~~~ it is judged only while the machine is in 'Idle'
a.ss:6:17: warning: this condition cannot be false here [W0752 decided-assert]
    6 | T < 50: @assert Open != S
      |                 ^~~~~~~~~ it is judged only while the machine is in 'Idle'
a.ss:7:30: warning: this condition cannot be false here [W0752 decided-assert]
    7 | T < 50: @assert not open and S == Idle
      |                              ^~~~~~~~~ it is judged only while the machine is in 'Idle'
a.ss:10:13: warning: this condition cannot be false here [W0752 decided-assert]
   10 |     @assert S != Idle "open for 50 ms"
      |             ^~~~~~~~~ it is judged only while the machine is in 'Open'
5 warnings
b.ss:3:13: error: this condition cannot be false here [W0752 decided-assert]
    3 |     @assert second.S == Open
      |             ^~~~~~~~~~~~~~~~ it is judged only while the machine is in 'second.Open'
1 error
-- exit --
0 1
