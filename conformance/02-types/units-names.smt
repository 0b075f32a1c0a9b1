spec 2.26  The units and their prefixes.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x0 @unit m
F64 x1 @unit g
F64 x2 @unit s
F64 x3 @unit A
F64 x4 @unit K
F64 x5 @unit mol
F64 x6 @unit cd
F64 x7 @unit rad
F64 x8 @unit sr
F64 x9 @unit Hz
F64 x10 @unit N
F64 x11 @unit Pa
F64 x12 @unit J
F64 x13 @unit W
F64 x14 @unit C
F64 x15 @unit V
F64 x16 @unit F
F64 x17 @unit ohm
F64 x18 @unit S
F64 x19 @unit Wb
F64 x20 @unit T
F64 x21 @unit H
F64 x22 @unit lm
F64 x23 @unit lx
F64 x24 @unit L
F64 x25 @unit bar
F64 x26 @unit min
F64 x27 @unit h
F64 x28 @unit t
F64 x29 @unit atm
F64 x30 @unit deg
F64 x31 @unit percent
F64 x32 @unit rev
F64 x33 @unit rpm
F64 x34 @unit psi
F64 x35 @unit ft
F64 x36 @unit in
F64 x37 @unit mi
F64 x38 @unit kn
F64 x39 @unit lb
F64 x40 @unit lbf
F64 x41 @unit degC
F64 x42 @unit degF
F64 x43 @unit gn
F64 x44 @unit pA
F64 x45 @unit nm
F64 x46 @unit uV
F64 x47 @unit mm
F64 x48 @unit cm
F64 x49 @unit dm
F64 x50 @unit dag
F64 x51 @unit hPa
F64 x52 @unit km
F64 x53 @unit MPa
F64 x54 @unit GHz
F64 x55 @unit TW
F64 x56 @unit mrad

[Run] @safe
.step
    x0 = 0
    x1 = 1
    x2 = 2
    x3 = 3
    x4 = 4
    x5 = 5
    x6 = 6
    x7 = 7
    x8 = 8
    x9 = 9
    x10 = 10
    x11 = 11
    x12 = 12
    x13 = 13
    x14 = 14
    x15 = 15
    x16 = 16
    x17 = 17
    x18 = 18
    x19 = 19
    x20 = 20
    x21 = 21
    x22 = 22
    x23 = 23
    x24 = 24
    x25 = 25
    x26 = 26
    x27 = 27
    x28 = 28
    x29 = 29
    x30 = 30
    x31 = 31
    x32 = 32
    x33 = 33
    x34 = 34
    x35 = 35
    x36 = 36
    x37 = 37
    x38 = 38
    x39 = 39
    x40 = 40
    x41 = 41
    x42 = 42
    x43 = 43
    x44 = 44
    x45 = 45
    x46 = 46
    x47 = 47
    x48 = 48
    x49 = 49
    x50 = 50
    x51 = 51
    x52 = 52
    x53 = 53
    x54 = 54
    x55 = 55
    x56 = 56

-- app.ss --
[options]
delta_t 10

[all_states]
G == 0 {
    @assert x3 == 3
    @stop
}
