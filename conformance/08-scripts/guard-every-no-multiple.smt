spec 8.42  `every` needs a multiple of delta_t above 0.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
F64 n
[A]
.step
    x = p
    T == 30: -> Burn
[Burn]
.step
    x = p + 1000
-- app.ss --
[options]
delta_t 10
[all_states]
every 15: p = 1         #! E0758 'every 15' needs a multiple of delta_t, which is 10 ms
every 0: p = 1          #! E0758
every 5 ms: p = 1       #! E0758
every 20.5: p = 1       #! E0758
every 1e30: p = 1       #! E0758
every 30: p = 1
at 100: @stop
