spec 13.9, 13.3  A state is its name, or S == its name.
expect error

-- app.sm --
[state_vector]
U64 G
U32 S
bool on

[A] @safe
.step
    on = T > 3
    on: -> B
[B] @safe
.step
    not on: -> A
-- app.rq --
R1 "x"  never state A and on          #! E0329 write S == A
R2 "x"  never state A before (on)     #! E0329 write A
R3 "x"  never (on) before state B     #! E0329 write B
R4 "x"  never (on) after state B without (on)      #! E0329 write B
R5 "x"  always (state A) implies on   #! E0329 write S == A
R6 "x"  never (on) after B without state A   #! E0329 write A
R7 "x"  never state                   #! E0204
-- app.ss --
[options]
delta_t 10
[all_states]
G == 20: @assert on
G == 20: @stop
