# Every element gets a value of its own, so that two of them in one place would be seen.
[options]
delta_t 1
[all_states]
G == 0 {
    int = 1.5
    class = 2.5
    errno = 3.5
    NULL = 4.5
    EOF = 5.5
    stdin = 6.5
    INT8_MAX = 7.5
    unix = 8.5
    linux = 9.5
    _x = 10.5
    __y = 11.5
    x__y = 12.5
    x_y = 13.5
    int_ = 14.5
    m = 15.5
    sv = 16.5
    value1 = 17.5
    test1 = 18.5
    next = 19.5
    first = 20.5
    now = 21.5
    sm_to_u8 = 22.5
    sm_read_f64 = 23.5
    memcpy = 24.5
    memset = 25.5
    names_step = 26.5
    names_is_fit = 27.5
    NamesSv = 28.5
    NAMES_H = 29.5
    NAMES_SV_LAYOUT = 30.5
    NAMES_OK = 31.5
    uint8_t = 32.5
    size_t = 33.5
    double = 34.5
    restrict = 35.5
    _Bool = 36.5
    this = 37.5
    near = 38.5
    INFINITY = 39.5
    I = 40.5
    L1 = 41.5
    main = 42.5
    pad_at_12_ = 43.5
}
G == 0: @assert m == 15.5 + 16.5 * 3 + 16.5
G == 60: @stop
