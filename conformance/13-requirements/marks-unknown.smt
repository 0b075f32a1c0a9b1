spec 13.21  An @req whose id no requirement has causes a warning.

-- app.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p @read_only
bool on

[all_states] @req R17
@except B
.step
    p == 9: -> B  @req R71   #! W1302 no requirement has the id 'R71'

[A] @req R17
.step
    on = p > 1  @req R16      #! W1302 did you mean 'R17'?
    p == 3: -> B
    if p == 5 {
        on = true
    }

[B] @safe

-- app.rq --
R17 "a"  never p > 100

-- app.ss --
[all_states]
G == 0: p = 1
G == 10: @assert p == 1 @req R17
G == 10: @assert p == 1 @req R18          #! W1302 did you mean 'R17'?
G == 10: @stop
