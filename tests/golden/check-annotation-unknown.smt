# Where no name is near, an unknown annotation is answered with what may stand there.
args check a.sm
args check a.io --sv a.sv
args check a.app

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x @slot
[local]
F64 y = 0 @const
[Idle] @initial
[Other] @abrot
-- a.sv --
[A]
U64 time
F64 x @slot
bool b
-- a.io --
[analog]
i 0 x @filter 3
[digital]
o 9 b @frequency 3
o 8 b @pul_up
-- b.sv --
[A]
U64 time
-- a.app --
[options]
state_vector "b.sv"
[main] @core 1
every 10 ms:
    task control @critical
    task other @modes
-- stderr --
a.sm:4:7: error: unknown annotation '@slot' [E0360]
    4 | F64 x @slot
      |       ^~~~~ here may stand @read_only, @alias, @range, @command and @allow
a.sm:6:11: error: unknown annotation '@const' [E0360]
    6 | F64 y = 0 @const
      |           ^~~~~~ here may stand @read_only and @allow
a.sm:7:8: error: unknown annotation '@initial' [E0360]
    7 | [Idle] @initial
      |        ^~~~~~~~ here may stand @allow, @abort and @safe
a.sm:8:9: error: unknown annotation '@abrot' [E0360]
    8 | [Other] @abrot
      |         ^~~~~~ did you mean '@abort'?
4 errors
a.sv:3:7: error: unknown annotation '@slot' [E0360]
    3 | F64 x @slot
      |       ^~~~~ here may stand @range, @command and @allow
a.io:2:7: error: unknown annotation '@filter' [E0360]
    2 | i 0 x @filter 3
      |       ^~~~~~~ here may stand @allow, @scale, @offset and @hold
a.io:4:7: error: unknown annotation '@frequency' [E0360]
    4 | o 9 b @frequency 3
      |       ^~~~~~~~~~ here may stand @allow, @safe and @inverted
a.io:5:7: error: unknown annotation '@pul_up' [E0360]
    5 | o 8 b @pul_up
      |       ^~~~~~~ here may stand @allow, @safe and @inverted
4 errors
a.app:3:8: error: unknown annotation '@core' [E0360]
    3 | [main] @core 1
      |        ^~~~~ here may stand @priority, @overrun, @ticks, @overruns, @skipped, @late, @busy and @allow
a.app:5:18: error: unknown annotation '@critical' [E0360]
    5 |     task control @critical
      |                  ^~~~~~~~~ here may stand @mode, @init, @safe and @allow
a.app:6:16: error: unknown annotation '@modes' [E0360]
    6 |     task other @modes
      |                ^~~~~~ did you mean '@mode'?
3 errors
-- exit --
1 1 1
