# Machines over one state vector: each element has one writer, each state and each time an element of its own.
args check --sv=v.sv a.sm b.sm c.sm
args build --sv=v.sv a.sm c.sm -o all.smb
args check a.sm b.sm

-- v.sv --
[All]
U64 time
U64 clock
U32 aState
U32 S
bool valve
bool lamp
-- a.sm --
[state_vector]
U64 time @alias G
U32 aState @alias S
bool valve
bool lamp @read_only
[Idle]
.step
    valve = lamp
    valve and T > 5: valve = false
-- b.sm --
[state_vector]
U64 clock @alias G
U32 S
U64 time
U32 aState
bool valve @alias door
bool lamp
[Idle]
.step
    lamp = true
    door = true
    time = clock
    aState = 2
-- c.sm --
[state_vector]
U64 time @alias G
U32 S
U64 clock
bool valve @read_only
bool lamp @read_only
[Idle]
.step
    valve and lamp: clock = G
-- stderr --
b.sm:11:5: warning: machine 'b' writes 'valve', and so does machine 'a' [W0960 two-writers]
   11 |     door = true
      |     ^~~~~~~~~~~
a.sm:8:5: note: machine 'a' writes it here
b.sm:12:5: warning: machine 'b' writes 'time', which is the time, G, of machine 'a' [W0962 two-writers]
   12 |     time = clock
      |     ^~~~~~~~~~~~
a.sm:2:5: note: machine 'a' lists it here
b.sm:13:5: warning: machine 'b' writes 'aState', which is the state, S, of machine 'a' [W0963 two-writers]
   13 |     aState = 2
      |     ^~~~~~~~~~
a.sm:3:5: note: machine 'a' lists it here
c.sm:3:5: warning: machine 'c' stores its state in 'S', and so does machine 'b' [W0961 two-writers]
    3 | U32 S
      |     ^
b.sm:3:5: note: machine 'b' lists it here
c.sm:9:21: warning: machine 'c' writes 'clock', which is the time, G, of machine 'b' [W0962 two-writers]
    9 |     valve and lamp: clock = G
      |                     ^~~~~~~~~
b.sm:2:5: note: machine 'b' lists it here
5 warnings
-- exit --
0 0 0
