# A file that is named twice is one file: what is found in it is reported once.
args check a.sm a.ss a.ss

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- a.ss --
[options]
delta_t 10
[all_states]
G == 15: @stop
G == 20: @stop
-- stderr --
a.ss:4:1: warning: 'G' is never exactly 15: it advances by 10 [W0702 exact-moment]
    4 | G == 15: @stop
      | ^~~~~~~
1 warning
