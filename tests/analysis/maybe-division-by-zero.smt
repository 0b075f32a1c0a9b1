# By what can be 0: guards of every kind, stores, functions and @range exclude it.
warn maybe-division-by-zero no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 a @read_only
F64 b @read_only
U8 n @read_only
F64 supply @read_only @range 1 40
F64 flow @read_only @range 0 40
F64 x
U8 u
bool y
bool p @read_only
bool q @read_only
bool r @read_only
[local]
F64 first = 5
F64 d = 0
F64 eps = 0.001 @read_only
U32 count = 1
[Hold]
.entry
    first = supply
    count = 1
.step
    x = a / b                         #! W0417 'b' can be 0 here: the division then results in an infinity, or NaN
    u = a / n                         #! W0417 an infinity, stored as 255
    y = a / b > 3                     #! W0417
    x = a / (a - b)                   #! W0417 'a - b'
    x = a / T                         #! W0417 'T'
    x = a / flow                      #! W0417 'flow'
    x = a / roll_range(supply, 5)     #! W0417
    x = roll_avg(a / n, 5)            #! W0417 'n'
    a >= b: x = 1 / (a - b)           #! W0417
    b != 0 or a / b > 3: x = 1        #! W0417
    b > -5: x = 1 / b                 #! W0417
    x = 1 / supply
    x = 1 / first
    x = 1 / count
    count = count + 1
    x = a / max(b, 1)
    x = a / (n + 1)
    x = 1 / roll_avg(supply, 5)
    x = 1 / (supply * supply)
    T > 0: x = a / T
    b > 5: x = a / b
    p or q: x = a / (p + q)
    p or q {
        x = a / (p + q)
    }
    p + q > 0: x = a / (p + q)
    p: x = a / (q + p)
    p or q or r: x = a / (p + q + r)
    p or n > 3: x = a / (n + p)
    p or q: x = a / max(p, q)
    p or q: x = a / (-p - q)
    not p and not q: x = 0
    else: x = a / (p + q)
    p or q: x = a / (p + r)           #! W0417 'p + r'
    p or q: x = a / (p - q)           #! W0417 'p - q'
    not p or q: x = a / (p + q)       #! W0417 'p + q'
    a > 0 or b > 0: x = 1 / (a + b)   #! W0417 'a + b'
    p or q: x = 1 / (p + q + a)       #! W0417 'p + q + a'
    n != 0: x = a / n
    n: x = a / n
    a > b: x = 1 / (a - b)
    a != b: x = 1 / (b - a)
    abs(b) > eps: x = 1 / b
    b > 0.1 or b < -0.1: x = 1 / b
    0 < a - b < 3: x = 1 / (a - b)
    a * b != 0: x = 1 / (a * b)
    a > 0 and b > 0: x = 1 / (a * b)
    a - b != 0 and 5 / (a - b) > 2: x = 1
    a - b == 0 or 5 / (a - b) > 2: x = 1
    d = b
    d < 1: d = 1
    x = x + 1 / d
    d = a - b
    d == 0: -> Run
    x = x + 1 / d
    abs(d) < 0.1 {
        x = 1
    }
    else {
        x = 1 / d
        d = b
        x = 1 / d                     #! W0417 'd'
    }
[Run]
