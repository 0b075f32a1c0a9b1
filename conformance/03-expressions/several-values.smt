spec 3.42, 3.43, 3.44, 3.45, 3.47   The smallest, largest, middle and average of 2 to 16 values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 b
F64 c
F64 d
F32 e
U8  u
U16 v
F64 low
F64 high
F64 odd
F64 even
F64 mean
F64 pair
F64 whole
F64 long
F64 written
bool nan

[local]
F64 inf = 1 / 0 @read_only
F64 of_three = max(1, 2, 3)

[Run]
.step
    low = min(a, b, c)
    high = max(a, b, c, d, e)
    odd = median(a, b, c)
    even = median(a, b, c, d)
    mean = average(a, b, c)
    pair = median(a, b)
    whole = median(u, v)
    long = median(a, b, c, d, e, u, v, 1 - a, 3 - b, 1 - c, 1 - d, a + b, a - b, c + d, c - d, 0 - e)
    written = max(a, 0,5)              #! W0460
    nan = not (low == low or high == high or odd == odd or even == even or mean == mean)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    a = 3
    b = -1
    c = 7
    d = 2
    e = 0.5
    u = 200
    v = 7
    @assert of_three == 3
}
G == 0 {
    @assert low == -1 and high == 7
    @assert odd == 3 and even == 2.5
    @assert mean == 3 and pair == 1
    @assert whole == 103.5
    @assert long == 2.5
    @assert written == 5
}
# pairs, in the order written: (a + b) + c, where one addition loses what the other keeps
G == 1 {
    a = 1e16
    b = -1e16
    c = 1
}
G == 1: @assert mean == 1 / 3
G == 2 {
    a = 1e16
    b = 1
    c = -1e16
}
G == 2: @assert mean == 0
# the difference of the two in the middle is not finite
G == 3 {
    a = 1.7e308
    b = -1.6e308
    c = 1.7e308
    d = -1.7e308
}
G == 3: @assert pair == a / 2 + b / 2 and even == pair
# rounded as roll_median is: a + (b - a) / 2
G == 4 {
    a = 5e-324
    b = 0
    c = 5e-324
    d = 1e-323
}
G == 4: @assert pair == 0 and odd == 5e-324 and even == 5e-324
# infinities
G == 5 {
    a = 1 / 0
    b = 1 / 0
    c = 2
    d = -1 / 0
}
G == 5: @assert pair == inf and odd == inf and even == inf and low == 2 and high == inf
G == 6 {
    a = -1 / 0
    b = 5
    c = -1 / 0
    d = -1 / 0
}
G == 6: @assert pair == -inf and odd == -inf and even == -inf
G == 7 {
    a = 5
    b = 1 / 0
    c = -1 / 0
    d = 5
}
G == 7: @assert pair == inf and odd == 5 and even == 5 and mean == 0
# zeros: -0 is below 0
G == 8 {
    e = -0
    a = -0
    b = 0
    c = 0
    d = -0
}
G == 8: @assert 1 / pair == -inf and 1 / odd == inf and 1 / even == -inf and 1 / low == -inf and 1 / high == inf and 1 / mean == inf
G == 9 {
    a = -0
    b = -0
    c = 0
    d = -0
}
G == 9: @assert 1 / pair == -inf and 1 / odd == -inf and 1 / even == -inf
G == 10: @stop
