# Warnings are fixed as far as their -W is on, in every file of the call, and an @allow keeps what it allows.
args fix app.sm app.sv app.ss --sv app.sv
args fix app.sm app.sv app.ss --sv app.sv -Wno-unused-allow -w

-- app.sm --
[state_vector]
U64 G
U32 S
F64 y
F64 x @allow(unused-element, "not true")
[Hold]
.step
    @allow(dead-code, "not true")
    x = 1
    @allow(empty-braces, "later") y > 3 { }
    @allow(dead-code, "not true") y > 2: x = 2
-- app.sv --
[A]
U64 G
U32 S
F64 y
F64 x @allow(unused-element, “for others”)
-- app.ss --
[options]
delta_t 1
[all_states]
G == 2 && S == 1: @stop
-- file app.sm --
[state_vector]
U64 G
U32 S
F64 y
F64 x
[Hold]
.step
    x = 1
    @allow(empty-braces, "later") y > 3 { }
    y > 2: x = 2
-- file app.sv --
[A]
U64 G
U32 S
F64 y
F64 x @allow(unused-element, "for others")
-- file app.ss --
[options]
delta_t 1
[all_states]
G == 2 and S == 1: @stop
-- stdout --
app.sm:5:
  - F64 x @allow(unused-element, "not true")
  + F64 x
app.sm:8:
  -     @allow(dead-code, "not true")
app.sm:11:
  -     @allow(dead-code, "not true") y > 2: x = 2
  +     y > 2: x = 2
app.sm: 3 fixed
app.sv:5:
  - F64 x @allow(unused-element, “for others”)
  + F64 x @allow(unused-element, "for others")
app.sv: 1 fixed
app.ss:4:
  - G == 2 && S == 1: @stop
  + G == 2 and S == 1: @stop
app.ss: 1 fixed
