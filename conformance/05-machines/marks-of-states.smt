spec 5.45, 5.46, 5.55  @abort, @safe and @swap follow a header, one or several, in any order, before the first label.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[A] @abort @safe
.step
    x = x + 1
    -> B
[B]@swap@safe@abort .step -> C
[C] @swap
# no fuel is left
@abort    # here
    @safe
.step
    -> D
[D] @safe @swap
-- app.ss --
[options]
delta_t 1
[all_states]
G == 4: @assert S == 4 and x == 1
G == 4: @stop
