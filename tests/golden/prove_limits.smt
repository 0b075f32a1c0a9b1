# smc prove: bounds that grow from step to step are widened to numbers of the machine.  `-5` in the text is the negation of 5, and one of them.
args prove a.sm a.rq

-- a.sm --
[options]
step 20 ms

[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  wanted @read_only
bool stop   @read_only
F64  angle

[Move]
.step
    angle = clamp(angle + clamp(wanted - angle, -0.2, 0.2), -5, 5)
    stop: -> Rest

[Rest] @safe
-- a.rq --
R1 "at most 5 degrees"       never abs(angle) > 5
-- stdout --
requirements of a, from state Move, with a step every 20 ms:
  R1  proved              at most 5 degrees
      assuming that only this machine writes the elements that it assigns
      in Move: angle is from -5 to 5
      in Rest: angle is from -5 to 5
