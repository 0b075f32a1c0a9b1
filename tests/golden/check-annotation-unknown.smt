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
      |       ^~~~~ allowed here: @read_only, @alias, @range, @command, @unit and @allow
a.sm:6:11: error: unknown annotation '@const' [E0360]
    6 | F64 y = 0 @const
      |           ^~~~~~ allowed here: @read_only, @range, @parameter, @unit and @allow
a.sm:7:8: error: unknown annotation '@initial' [E0360]
    7 | [Idle] @initial
      |        ^~~~~~~~ allowed here: @allow, @abort, @safe, @swap and @req
a.sm:8:9: error: unknown annotation '@abrot' [E0360]
    8 | [Other] @abrot
      |         ^~~~~~ did you mean '@abort'?
4 errors
a.sv:3:7: error: unknown annotation '@slot' [E0360]
    3 | F64 x @slot
      |       ^~~~~ allowed here: @range, @command, @unit and @allow
a.io:2:7: error: unknown annotation '@filter' [E0360]
    2 | i 0 x @filter 3
      |       ^~~~~~~ allowed here: @allow, @scale, @offset and @hold
a.io:4:7: error: unknown annotation '@frequency' [E0360]
    4 | o 9 b @frequency 3
      |       ^~~~~~~~~~ allowed here: @allow, @safe and @inverted
a.io:5:7: error: unknown annotation '@pul_up' [E0360]
    5 | o 8 b @pul_up
      |       ^~~~~~~ allowed here: @allow, @safe and @inverted
4 errors
a.app:3:8: error: unknown annotation '@core' [E0360]
    3 | [main] @core 1
      |        ^~~~~ allowed here: @priority, @overrun, @ticks, @overruns, @skipped, @late, @busy and @allow
a.app:5:18: error: unknown annotation '@critical' [E0360]
    5 |     task control @critical
      |                  ^~~~~~~~~ allowed here: @mode, @init, @safe and @allow
a.app:6:16: error: unknown annotation '@modes' [E0360]
    6 |     task other @modes
      |                ^~~~~~ did you mean '@mode'?
3 errors
-- exit --
1 1 1
