spec 3.42   One NaN among the values makes the result NaN, wherever it is.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 y
U8  place
bool any
U8  found

[Run]
.entry
    y = 2
.step
    any = median(sqrt(x), y, y + 1) == median(sqrt(x), y, y + 1)
    any = any or median(y, sqrt(x), y + 1) == median(y, sqrt(x), y + 1)
    any = any or median(y, y + 1, sqrt(x)) == median(y, y + 1, sqrt(x))
    any = any or median(y, sqrt(x)) == median(y, sqrt(x))
    any = any or median(sqrt(x), y) == median(sqrt(x), y)
    any = any or median(y, y, y, y, sqrt(x), y, y, y) == median(y, y, y, y, sqrt(x), y, y, y)
    any = any or average(y, y, sqrt(x)) == average(y, y, sqrt(x))
    any = any or min(y, sqrt(x), y) == min(y, sqrt(x), y)
    any = any or max(y, y, y, sqrt(x)) == max(y, y, y, sqrt(x))
    # infinities of both signs in the middle
    found = median(x / 0, -x / 0) != median(x / 0, -x / 0)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: x = -1
G == 0: @assert not any
G == 0: @assert found
G == 1: x = 4
G == 1: @assert any
G == 2: @stop
