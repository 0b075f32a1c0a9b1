# With --mutate a report lists the changes that no script notices, with inputs that would show them.
args report a.sm a.ss --mutate --format=text | sed -n '/no script notices/,/^Source/p'
args report a.sm bad.ss --mutate --format=text | grep -c 'What no script notices'

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool open

[Fill]
.step
    open = p > 700   # the vent
    p > 825: -> Abort

[Abort] @abort @safe

-- a.ss --
[options]
delta_t 10
[all_states]
G == 10: p = 900
G == 20 {
    @assert open
    @stop
}
-- bad.ss --
[options]
delta_t 10
[all_states]
G == 10: @assert open
G == 50: @stop
-- stdout --
What no script notices
----------------------

The machine is changed in one place at a time, and all scripts run again. A change that no script
notices is a fault that these tests would not find. The most dangerous ones come first.

The scripts notice 4 of 12 changes (33.3 %). Changes that make no difference are not counted: 0.

  State  Noticed  Of
  Fill         4  12

On the way to an abort
  Line  As written         Change that no script notices                                    Inputs that would show it
    10  p > 825: -> Abort  `p > 825` changed to `0` in Fill, on the way to an @abort state  from Fill, at G = 0: p = 900; at G = 10, S differs
    10  p > 825: -> Abort  `>` changed to `>=` in Fill, on the way to an @abort state       from Fill, at G = 0: p from 699.3 by 41.90000000000001 a step; at G = 40, S differs
    10  p > 825: -> Abort  `825` changed to `743` in Fill, on the way to an @abort state    from Fill, at G = 0: p = 772.1333333333333; at G = 10, S differs
    10  p > 825: -> Abort  `825` changed to `907` in Fill, on the way to an @abort state    from Fill, at G = 0: p = 900; at G = 10, S differs
    10  p > 825: -> Abort  `-> Abort` removed in Fill, on the way to an @abort state        from Fill, at G = 0: p = 900; at G = 10, S differs

At an output
  Line  As written      Change that no script notices              Inputs that would show it
     9  open = p > 700  `>` changed to `>=` in Fill, an output     from Fill, at G = 0: p = 700; at G = 0, open differs
     9  open = p > 700  `700` changed to `630` in Fill, an output  from Fill, at G = 0: p = 699.3; at G = 0, open differs
     9  open = p > 700  `700` changed to `770` in Fill, an output  from Fill, at G = 0: p = 722.8666666666667; at G = 0, open differs

0
-- stderr --
smc: bad.ss failed; the report shows why
-- exit --
0 1
