spec 13.21  More than three unknown ids of a machine, or of a script, are one warning.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[A] @req R1                       #! W1302 no requirement has the id 'R1'
.step
    on = p > 1  @req R2
    on = on and p < 9  @req R3
    p == 3: -> B  @req R4
    p == 4: -> B  @req R2 @req R17

[B] @safe

-- app.rq --
R17 "a"  never p > 100

-- app.ss --
[all_states]
G == 0: p = 1
G == 10: @assert p == 1 @req R1
G == 10: @assert p == 1 @req S1   #! W1302 no requirement has the id 'S1'
G == 10: @assert p == 1 @req R4
G == 10: @assert p == 1 @req S2
G == 10: @assert p == 1 @req S3
G == 10: @assert p == 1 @req S4
G == 10: @stop
