spec 2.22, 5.11  The same as initial values.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[local]
bool k00 = 0
bool k01 = -0.0
bool k02 = 1
bool k03 = 0.5
bool k04 = -3
bool k05 = 256
bool k06 = 65536
bool k07 = 4294967296
bool k08 = 1e+300
bool k09 = 1e-300
bool k10 = 5e-324
bool k11 = 1/0
bool k12 = -1/0
bool k13 = 0/0

[Run]
.step
    x = k00

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 0
    @stop
}

-- trace --
1 k00 false
1 k01 false
1 k02 true
1 k03 true
1 k04 true
1 k05 true
1 k06 true
1 k07 true
1 k08 true
1 k09 true
1 k10 true
1 k11 true
1 k12 true
1 k13 false
