# smc prove on values: ends of ranges and of types, the last store of a step, .exit, times, and limits of `within` on both sides.
args prove a.sm a.rq --effort=1 | grep '^  V\|parameters have'
args prove a.sm a.rq --effort=1 --assume-ranges --requirements=V13,V17 | grep '^  V'

-- a.sm --
[options]
step 20 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  p      @read_only @range -2 8
I16  n      @read_only
U64  big    @read_only
bool on     @read_only
bool q      @read_only
F64  out
bool flag
U8   small

[local]
F64  limit = 4 @parameter @range 1 6
I8   low   = -3 @parameter @range -5 -1
U32  turns = 0

[Run]
.entry
    turns = turns + 1
.step
    flag = on
    flag = on and q
    small = n
    T >= 90 ms: -> Wait
    p > limit and on: -> Wait

[Wait]
.step
    out = clamp(p, low, limit)
    small = 250 + turns
    T > 50 ms: -> Run
.exit
    flag = true
-- a.rq --
V3 "the last store counts"          never S == Run and flag and not q
V4 "or both are true"               never S == Run and flag and not (on and q) and not prev(S == Wait)
V5 "times are multiples of a step"  never S == Run and 80 < T < 100
V6 "the last time"                  never S == Run and T >= 100
V7 "is reached"                     never S == Run and T >= 99
V8 "the upper end of a parameter"   never out > 4
V9 "the upper end of all"           never out > 6
V10 "the lower end of a parameter"  never out < -3
V11 "the lower end of all"          never out < -5
V12 "the exit"                      never S == Run and T == 0 and turns > 1 and not prev(flag)
V13 "the range of an input"         never p > 8
V14 "saturation"                    never S == Wait and small > 252
V17 "large numbers"                 never big + 1 == big
V18 "within a step more"            always S == Wait leads to S == Run within 60 ms
V19 "within a step less"            always S == Wait leads to S == Run within 59 ms
V20 "between states"                always T == 0 and S == Run leads to S == Run and T == 0 within 160 ms
V21 "and less"                      always T == 0 and S == Run leads to T == 0 and S == Wait within 80 ms
V22 "once after a reset"            never (S == Wait) after (S == Run) without (T == 0)
V23 "after two"                     never (S == Wait and on) after (q) without (not q)
V24 "never twice without a wait"    never (S == Run and T == 0) after (S == Run and T > 0) without (S == Wait)
V25 "an overwritten store"          never S == Run and on and not flag
-- stdout --
  V3   proved              the last store counts
  V4   proved              or both are true
  V5   proved              times are multiples of a step
  V6   violated            the last time
  V7   violated            is reached
  V8   proved              the upper end of a parameter
      assuming that the parameters have the values in the source (smc sweep tries others)
  V9   proved              the upper end of all
  V10  proved              the lower end of a parameter
      assuming that the parameters have the values in the source (smc sweep tries others)
  V11  proved              the lower end of all
  V12  proved              the exit
  V13  violated            the range of an input
  V14  violated            saturation
  V17  violated            large numbers
  V18  violated            within a step more
  V19  violated            within a step less
  V20  proved              between states
  V21  violated            and less
  V22  violated            once after a reset
  V23  violated            after two
  V24  proved              never twice without a wait
  V25  violated            an overwritten store
  V13  proved              the range of an input
  V17  violated            large numbers
