# The most dangerous changes come first: what fires a charge before a lamp, a vent that an abort opens, and a code for people. A transition to a state
# that switches a hazard on is as dangerous.
args mutate a.sm a.ss

-- a.sm --
[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  h      @read_only
bool lamp
bool vent
bool charge
U8   code

[all_states]
.step
    lamp = S == Fall or S == Landed
    vent = S == Abort or h < 3

[Fall]
.step
    code = 2
    h < 7: -> Fire
    h < 1: -> Abort

[Fire]
.entry
    charge = true
.step
    T >= 1000: -> Landed
.exit
    charge = false

[Landed] @safe

[Abort] @abort @safe
-- a.ss --
[options]
delta_t 100
[all_states]
G == 0: h = 100
G == 900: @assert not charge
G == 1000: @stop
-- stdout --
mutations of a: 2 of 34 changes are noticed (5.9 %), and 6 make no difference
not noticed:
  line 19:5: `h < 1` changed to `1` in Fall, on the way to an @abort state
  line 19:7: `<` changed to `>=` in Fall, on the way to an @abort state
  line 18:5: `h < 7` changed to `0` in Fall, a hazardous output
  line 18:7: `<` changed to `<=` in Fall, a hazardous output
  line 18:9: `7` changed to `6` in Fall, a hazardous output
  line 18:9: `7` changed to `8` in Fall, a hazardous output
  line 18:12: `-> Fire` removed in Fall, a hazardous output
  line 18:15: `Fire` changed to `Landed` in Fall, a hazardous output
  line 23:5: `charge = true` removed in Fire, a hazardous output
  line 27:5: `charge = false` removed in Fire, a hazardous output
  line 12:5: `lamp = S == Fall or S == Landed` removed, an output
  line 12:14: `==` changed to `!=`, an output
  line 12:22: `or` changed to `and`, an output
  line 12:27: `==` changed to `!=`, an output
  line 13:5: `vent = S == Abort or h < 3` removed, an output
  line 13:14: `==` changed to `!=`, an output
  line 13:23: `or` changed to `and`, an output
  line 13:28: `<` changed to `<=`, an output
  line 13:28: `<` changed to `>=`, an output
  line 13:30: `3` changed to `2`, an output
  line 13:30: `3` changed to `4`, an output
  line 17:5: `code = 2` removed in Fall, an output
  line 17:12: `2` changed to `1` in Fall, an output
  line 17:12: `2` changed to `3` in Fall, an output
  line 25:5: `T >= 1000` changed to `0` in Fire
  line 25:5: `T >= 1000` changed to `1` in Fire
  line 25:7: `>=` changed to `<` in Fire
  line 25:7: `>=` changed to `>` in Fire
  line 25:10: `1000` changed to `1100` in Fire
  line 25:10: `1000` changed to `900` in Fire
  line 25:16: `-> Landed` removed in Fire
  line 25:19: `Landed` changed to `Abort` in Fire
