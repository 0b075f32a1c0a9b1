# -Werror=name makes an error of one.
args check -Werror=unused-element a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
F64 spare
[Idle]
.step
    open = true
[Lost]
.step
    open = false
-- stderr --
a.sm:5:5: error: element 'spare' is never used [W0203 unused-element]
    5 | F64 spare
      |     ^~~~~
a.sm:9:2: warning: state 'Lost' is unreachable [W0503 unreachable-state]
    9 | [Lost]
      |  ^~~~ no transition leads here: write -> Lost below a condition of another state
1 error, 1 warning
-- exit --
1
