# There and back in every step: limits that overlap, sums, locals, statistics that have settled, two buttons.
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
[local]
F64 smooth = 0
F64 set = 20 @read_only
[A]
.step
    p > 20: -> B                        #! W0924 can flip between 'A' and 'B' in every step
    T > 1: -> C
[B]
.step
    p < 25: -> A
[C]
.step
    p > q + 2: -> D                     #! W0924 'C' and 'D'
    T > 1: -> E
[D]
.step
    p - q < 3: -> C
[E]
.step
    smooth = roll_avg(p, 20)
    smooth > set: -> F                  #! W0924 'E' and 'F'
    T > 1: -> M
[F]
.step
    roll_median(p, 5) < set + 5: -> E
[M]
.step
    open: -> N                          #! W0924 'M' and 'N'
    T > 1: -> P
[N]
.step
    shut: -> M
[P]
.step
    mode != 3: -> Q                     #! W0924
[Q]
.step
    mode > 3: -> P
