spec 2.2   Elements are compared with constants by value, F32 elements also with constants that are not F32 values.

-- app.sm --
[state_vector]
U64 G
U32 S
F32 f
F64 d
U8  f_zero
U8  d_zero
U8  f_five
U8  d_five
U8  f_minus
U8  d_minus
U8  f_big
U8  d_big
U8  f_mbig
U8  d_mbig
U8  f_small
U8  d_small
U8  f_msmall
U8  d_msmall

[Run]
.step
    f_zero = 0
    f < 0: f_zero = f_zero + 1
    f <= 0: f_zero = f_zero + 2
    f > 0: f_zero = f_zero + 4
    f >= 0: f_zero = f_zero + 8
    d_zero = 0
    d < 0: d_zero = d_zero + 1
    d <= 0: d_zero = d_zero + 2
    d > 0: d_zero = d_zero + 4
    d >= 0: d_zero = d_zero + 8
    f_five = 0
    f < 5: f_five = f_five + 1
    f <= 5: f_five = f_five + 2
    f > 5: f_five = f_five + 4
    f >= 5: f_five = f_five + 8
    d_five = 0
    d < 5: d_five = d_five + 1
    d <= 5: d_five = d_five + 2
    d > 5: d_five = d_five + 4
    d >= 5: d_five = d_five + 8
    f_minus = 0
    f < -5: f_minus = f_minus + 1
    f <= -5: f_minus = f_minus + 2
    f > -5: f_minus = f_minus + 4
    f >= -5: f_minus = f_minus + 8
    d_minus = 0
    d < -5: d_minus = d_minus + 1
    d <= -5: d_minus = d_minus + 2
    d > -5: d_minus = d_minus + 4
    d >= -5: d_minus = d_minus + 8
    f_big = 0
    f < 1.606938044258990275541962092341162602522202993782792835301376e60: f_big = f_big + 1
    f <= 1.606938044258990275541962092341162602522202993782792835301376e60: f_big = f_big + 2
    f > 1.606938044258990275541962092341162602522202993782792835301376e60: f_big = f_big + 4
    f >= 1.606938044258990275541962092341162602522202993782792835301376e60: f_big = f_big + 8
    d_big = 0
    d < 1.606938044258990275541962092341162602522202993782792835301376e60: d_big = d_big + 1
    d <= 1.606938044258990275541962092341162602522202993782792835301376e60: d_big = d_big + 2
    d > 1.606938044258990275541962092341162602522202993782792835301376e60: d_big = d_big + 4
    d >= 1.606938044258990275541962092341162602522202993782792835301376e60: d_big = d_big + 8
    f_mbig = 0
    f < -1.606938044258990275541962092341162602522202993782792835301376e60: f_mbig = f_mbig + 1
    f <= -1.606938044258990275541962092341162602522202993782792835301376e60: f_mbig = f_mbig + 2
    f > -1.606938044258990275541962092341162602522202993782792835301376e60: f_mbig = f_mbig + 4
    f >= -1.606938044258990275541962092341162602522202993782792835301376e60: f_mbig = f_mbig + 8
    d_mbig = 0
    d < -1.606938044258990275541962092341162602522202993782792835301376e60: d_mbig = d_mbig + 1
    d <= -1.606938044258990275541962092341162602522202993782792835301376e60: d_mbig = d_mbig + 2
    d > -1.606938044258990275541962092341162602522202993782792835301376e60: d_mbig = d_mbig + 4
    d >= -1.606938044258990275541962092341162602522202993782792835301376e60: d_mbig = d_mbig + 8
    f_small = 0
    f < 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_small = f_small + 1
    f <= 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_small = f_small + 2
    f > 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_small = f_small + 4
    f >= 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_small = f_small + 8
    d_small = 0
    d < 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_small = d_small + 1
    d <= 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_small = d_small + 2
    d > 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_small = d_small + 4
    d >= 6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_small = d_small + 8
    f_msmall = 0
    f < -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_msmall = f_msmall + 1
    f <= -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_msmall = f_msmall + 2
    f > -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_msmall = f_msmall + 4
    f >= -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: f_msmall = f_msmall + 8
    d_msmall = 0
    d < -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_msmall = d_msmall + 1
    d <= -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_msmall = d_msmall + 2
    d > -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_msmall = d_msmall + 4
    d >= -6.223015277861141707144064053780124240590252168721167133101116614789698834035383441183944823125713616956966589555e-61: d_msmall = d_msmall + 8

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    f = 0
    d = 0
    @assert f_zero == 10
    @assert d_zero == 10
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 1 {
    f = -(1 / (1/0))
    d = -(1 / (1/0))
    @assert f_zero == 10
    @assert d_zero == 10
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 2 {
    f = 5
    d = 5
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 10
    @assert d_five == 10
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 3 {
    f = -5
    d = -5
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 10
    @assert d_minus == 10
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 4 {
    f = 5.000000000000001
    d = 5.000000000000001
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 10
    @assert d_five == 12
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 5 {
    f = 4.999999999999999
    d = 4.999999999999999
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 10
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 6 {
    f = -5.000000000000001
    d = -5.000000000000001
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 10
    @assert d_minus == 3
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 7 {
    f = -4.999999999999999
    d = -4.999999999999999
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 10
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 8 {
    f = 1e38
    d = 1e38
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 12
    @assert d_five == 12
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 9 {
    f = -1e38
    d = -1e38
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 3
    @assert d_minus == 3
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 10 {
    f = 1/0
    d = 1/0
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 12
    @assert d_five == 12
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 12
    @assert d_big == 12
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 11 {
    f = -(1/0)
    d = -(1/0)
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 3
    @assert d_minus == 3
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 3
    @assert d_mbig == 3
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 12 {
    f = 1e-44
    d = 1e-44
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 13 {
    f = -1e-44
    d = -1e-44
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 14 {
    f = 1e300
    d = 1e300
    @assert f_zero == 12
    @assert d_zero == 12
    @assert f_five == 12
    @assert d_five == 12
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 12
    @assert d_big == 12
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 12
    @assert d_small == 12
    @assert f_msmall == 12
    @assert d_msmall == 12
}
G == 15 {
    f = -1e300
    d = -1e300
    @assert f_zero == 3
    @assert d_zero == 3
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 3
    @assert d_minus == 3
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 3
    @assert d_mbig == 3
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 3
    @assert d_msmall == 3
}
G == 16 {
    f = 0/0    #! W0409
    d = 0/0    #! W0409
    @assert f_zero == 10
    @assert d_zero == 10
    @assert f_five == 3
    @assert d_five == 3
    @assert f_minus == 12
    @assert d_minus == 12
    @assert f_big == 3
    @assert d_big == 3
    @assert f_mbig == 12
    @assert d_mbig == 12
    @assert f_small == 3
    @assert d_small == 3
    @assert f_msmall == 12
    @assert d_msmall == 12
    @stop
}
