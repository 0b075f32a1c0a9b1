# Hysteresis in all its forms, time, commands in two positions, latches, counters, states of one step.
warn no-all ping-pong

-- app.sm --
[state_vector]
U64 G
U32 S
F32 p @read_only
F32 q @read_only
bool open @read_only
bool shut @read_only
U8  mode @read_only
bool valve
[local]
F64 smooth = 0
U8  tries = 0
bool hot = false
U64 since = 0
[A]
.step
    p > 25: -> B
    T > 1: -> C
[B]
.step
    p < 20: -> A
[C]
.step
    p > q + 2: -> D
    T > 1: -> E
[D]
.step
    p < q - 2: -> C
[E]
.step
    smooth = roll_avg(p, 20)
    smooth > 30: -> F
    T > 1: -> H
[F]
.step
    smooth = roll_avg(p, 20)
    smooth < 25: -> E
[H]                                     # time
.step
    p > 20: -> I
    T > 100: -> J
[I]
.step
    T >= 500 and p < 25: -> H
[J]                                     # one command, two positions
.step
    open: -> K
    mode == 2: -> K
    T > 5: -> L
[K]
.step
    not open and mode == 1: -> J
[L]                                     # a latch
.step
    not valve and p > 20: -> M
    T > 5: -> N
[M]
.entry
    valve = true
.step
    p < 25: -> L
[N]                                     # three tries
.entry
    tries = tries + 1
.step
    p > 20 and tries < 3: -> O
    T > 5: -> P
[O]
.step
    p < 25: -> N
[P]                                     # R is one step long on purpose
.step
    p > 20: -> R
    T > 5: -> Q
[R]
.step
    -> P
[Q]
.step
    hot = p > 30
    hot: -> U
    T > 5: -> W
[U]
.step
    not (p > 30): -> Q
[W]
.step
    G - since > 1000 and p > 20: -> X
[X]
.entry
    since = G
.step
    p < 25: -> W
