# The page lists parameters with their unit, range, default, value and readers, apart from constants.
args report a.sm --format=text -o a.txt && sed -n '/^Parameters that can be set/,/^Locals/p' a.txt

-- a.sm --
[state_vector]
U64 G
U32 S
F64 x
[local]
F64 limit = 450 @parameter @range 150 1000 @unit m   # where the main opens
F32 gain = 0.1 @parameter @range -1.5 1.5
bool on = true @parameter
F64 two = 2 @read_only
F64 count = 0
[define]
half = limit / 2
[Run] @safe
.step
    count = count + two
    x = half * gain
    on: -> Next
[Next] @safe
.step
    x = count + limit
-- stdout --
Parameters that can be set
Values that are set before the machine starts, without compiling it again. The findings are true of
every value in the range.

  Parameter  Type  Unit  Range        Default  Value  Comment               Read in    Line
  limit      F64   m     150 to 1000  450      450    where the main opens  Run, Next     6
  gain       F32         -1.5 to 1.5  0.1      0.1                          Run           7
  on         bool                     true     true                         Run           8

Parameters
Named values that the machine never changes.

  Parameter  Type  Value  Read in  Line
  two        F64   2      Run         9

Locals
