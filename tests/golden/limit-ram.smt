# A machine that needs more memory than --max-ram allows is an error with its largest window, or without one at all.
args build a.sm --max-ram=1000
args check b.sm --max-ram=10

-- a.sm --
[state_vector]
U64 G
U32 S
F32 pressure @read_only
bool open
[Idle]
.step
    open = roll_avg(pressure, 10) > 5 and roll_max(pressure, 5000) > 100
-- b.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stderr --
a.sm:8:43: error: machine 'a' needs 60209 bytes of RAM on a 64-bit computer, but --max-ram allows 1000 [E0860]
    8 |     open = roll_avg(pressure, 10) > 5 and roll_max(pressure, 5000) > 100
      |                                           ^~~~~~~~~~~~~~~~~~~~~~~~ the largest window: 5000 samples, 60048 bytes
note: 60096 bytes are for windows, 1 for locals, 112 for the VM itself
1 error
b.sm:1:1: error: machine 'b' needs 96 bytes of RAM on a 64-bit computer, but --max-ram allows 10 [E0860]
    1 | [state_vector]
      | ^
note: 0 bytes are for windows, 0 for locals, 96 for the VM itself
1 error
-- exit --
1 1
