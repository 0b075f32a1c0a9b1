spec 13.19, 13.20  Marks follow states, statements and transitions, and change nothing.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[all_states] @req R6
@except B
.step
    p == 9: -> B @req R5

[A] @req R1 @req R2
.step
    on = p > 1  @req R1
    p == 3: -> B @req R3 @req R1
    if p == 5 {
        on = true
    } @req R4

[B] @safe @req R2

-- app.rq --
R1 "a"  always S == A and p < 9 implies on == (p > 1)
R2 "b"  always S == B or S == A
R3 "c"  always S == A and p == 3 leads to S == B within 10 ms
R4 "d" always p == 5 implies on
R5 "e"  always S == A and p == 9 leads to S == B within 10 ms
R6 "f" always p >= 0

-- app.ss --
[all_states]
G == 0: p = 5
G == 10: p = 3
G == 20 {
    @assert S == B @req R3
    @assert on
    @stop
}

-- app1.ss --
[all_states]
G == 0:  p = 9
G == 10 {
    @assert S == B @req R5
    @stop
}
