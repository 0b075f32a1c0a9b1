# TAP has the requirements and the printed lines as comments.
args test --tap a.sm a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
bool open
[Idle]
.step
    open = p > 5
-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 7.5
G == 10: @expect open within 20 ms "the valve opens" @req R7
G == 20: @print p + 1, open "the level & more"
G == 20: @print S
G == 30: @assert open @req R7
G == 300: @fail "never at 30 < 40" @req R9
G == 40: @stop
-- stdout --
TAP version 13
1..1
ok 1 - a.ss
# requirements: R7 R9
# step 3 (G = 20), the level & more: p + 1 = 8.5, open = true
# step 3 (G = 20): S = Idle, number 1
