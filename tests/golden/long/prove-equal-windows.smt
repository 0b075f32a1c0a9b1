# smc prove: windows of the machine and of a requirement that store the same runs, although their conditions are written differently (A1, A2), or read
# the sample of another window (A3).  The windows of the feedbacks have too many runs for a proof that follows all of them: A4 follows one of them.
# B1 to B4 are violated, because the runs differ.
args prove a.sm a.rq --effort=1 | grep '^  [AB]'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64  time      @alias G
U32  state     @alias S
F32  a         @read_only
F32  b         @read_only
bool open1     @read_only
bool open2     @read_only
bool open3     @read_only
U32  heartbeat @read_only
bool start     @read_only
bool valve1
bool valve2
bool valve3
U8   code

[define]
isHigh = held(max(a, b) > 60, 30 ms)
isLost = held(heartbeat == prev(heartbeat), 1 s)
isUnfed = held(valve1 != open1, 290 ms) or held(valve2 != open2, 290 ms) or held(valve3 != open3, 290 ms)

[Idle]
.entry
    code = 0
.step
    valve1 = false
    valve2 = false
    start: -> Fill

[Fill]
.step
    valve2 = T < 100 ms
    valve1 = true
    isHigh {
        code = 1
        -> Abort
    }
    isUnfed or isLost: -> Abort

[Abort]
.step
    valve3 = T > 50 ms
    T > 1 s: -> Idle
-- a.rq --
A1 "or instead of max"       always held(a > 60 or b > 60, 30 ms) and S == Fill leads to S == Abort and code == 1 within 10 ms
A2 "not and"                 always held(not (a <= 60 and not (60 < b)), 30 ms) and S == Fill leads to S == Abort within 10 ms
A3 "the same of prev"        always held(heartbeat == prev(heartbeat), 1 s) and S == Fill leads to S == Abort within 10 ms
A4 "as the machine samples"  always held(prev(valve1) != open1, 290 ms) and S == Fill leads to S == Abort within 10 ms
B1 "another limit"           always held(a > 59 or b > 60, 30 ms) and S == Fill leads to S == Abort within 10 ms
B2 "only one of them"        never S == Abort and T == 0 and code == 1 and not prev(held(a > 60, 30 ms))
B3 "the next sample"         always held(valve1 != open1, 290 ms) and S == Fill leads to S == Abort within 10 ms
B4 "a shorter time"          always held(a > 60 or b > 60, 20 ms) and S == Fill leads to S == Abort within 10 ms
-- stdout --
  A1  proved              or instead of max
  A2  proved              not and
  A3  proved              the same of prev
  A4  proved              as the machine samples
  B1  violated            another limit
  B2  violated            only one of them
  B3  violated            the next sample
  B4  violated            a shorter time
-- exit --
0
