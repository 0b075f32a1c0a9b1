# A changed definition: what it was and is, at each use that is written as before, and as a note of its own.
args diff c.sm d.sm
args diff d.sm e.sm --format=json | grep -c definition

-- c.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool v

[define]
limit = 700
high  = p > limit

[Fill]
.step
    v = high
    high and p > 900: -> Done

[Done]
-- d.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool v

[define]
limit = 750
high  = p > limit

[Fill]
.step
    v = high
    high and p > 900: -> Done

[Done]
-- e.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool v

[define]
limit = 750
high  = p >= limit
low = p < 10

[Fill]
.step
    v = high
    high and p > 900: -> Done

[Done]
-- stdout --
comparison of c.sm with d.sm: behaviour changed: 2 changes
behaviour:
  ~ Fill: v in .step changed
      - v = high
      + v = high
      written as before, but 'limit' was 700 and is 750
  ~ Fill: -> Done changed
      - high and p > 900
      + high and p > 900
      stronger: no longer true when 700 < p <= 750
no change of behaviour:
  ~ definition limit changed
      - 700
      + 750
swap without stopping: not possible: no state of the old machine is marked @swap or @safe
3
-- exit --
1 0
