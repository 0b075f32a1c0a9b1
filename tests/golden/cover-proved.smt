# smc cover proves more goals impossible than facts about single values exclude, for runs in which only inputs change.
args cover a.sm -o made | grep -v '^wrote'

-- a.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F32 level @read_only @range 0 100
bool door @read_only
U32 rest
U8 slow

[Fill] @safe
.step
    rest = rest + 1
    level >= 99: -> Full
    held(level > 99.5, 50 ms): -> Never        # level was below 99 in this step
    T > 200 ms: -> Wait

[Full] @safe
.entry
    slow = 0
.step
    door: slow = slow + 1
    slow > 10 and T > 50 ms: -> Fill           # 11 steps take more than 50 ms
    roll_max(level, 3) < 50 and level > 60: -> Fill

[Wait] @safe
.step
    rest >= 20: -> Full                        # 21 steps of Fill have counted it

[Never] @safe
-- stdout --
goals of a: 53 of 53 reached, and 13 impossible
impossible:
  line 16: `held(level > 99.5, 50 ms)` was never true: the conditions before it and beside it exclude it
  line 24: `T > 50 ms` was never false while it decided: what is counted before it takes longer, if only inputs change, and delta_t is 10
  line 25: `roll_max(level, 3) < 50 and level > 60` was never true: the conditions before it and beside it exclude it
  line 29: `rest >= 20` was never false: `rest` is from 21 to 4294967295, if only inputs change, and delta_t is 10
  line 31: state Never was never entered: no run enters its state
  8 more goals, with the same cause as one of these
