# The pins that --io names are part of the image, so they count: without them the chip has room for it.
args build a.sm --sv app.sv --mcu=atmega328p -o a.smb
args build a.sm --sv app.sv --io app.io --mcu=atmega328p -o b.smb
args build a.sm --sv app.sv --io app.io --mcu=atmega2560 -o a.smb

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p
[Run] @safe
.step
    p = sqrt(abs(p))
-- app.sv --
[Sensors]
U64 G
U32 S
F64 p
F64 a0
F64 a1
F64 a2
F64 a3
F64 a4
F64 a5
F64 a6
F64 a7
F64 a8
F64 a9
F64 a10
F64 a11
F64 a12
F64 a13
F64 a14
F64 a15
F64 a16
F64 a17
F64 a18
F64 a19
F64 a20
F64 a21
F64 a22
F64 a23
F64 a24
F64 a25
F64 a26
F64 a27
F64 a28
F64 a29
F64 a30
F64 a31
F64 a32
F64 a33
F64 a34
F64 a35
F64 a36
F64 a37
F64 a38
F64 a39
F64 a40
F64 a41
F64 a42
F64 a43
F64 a44
F64 a45
F64 a46
F64 a47
F64 a48
F64 a49
F64 a50
F64 a51
F64 a52
F64 a53
F64 a54
F64 a55
F64 a56
F64 a57
F64 a58
F64 a59
F64 a60
F64 a61
F64 a62
F64 a63
-- app.io --
[analog]
i 0 a0 @scale 2.5 @offset -1.25
i 1 a1 @scale 2.5 @offset -1.25
i 2 a2 @scale 2.5 @offset -1.25
i 3 a3 @scale 2.5 @offset -1.25
i 4 a4 @scale 2.5 @offset -1.25
i 5 a5 @scale 2.5 @offset -1.25
i 6 a6 @scale 2.5 @offset -1.25
i 7 a7 @scale 2.5 @offset -1.25
i 8 a8 @scale 2.5 @offset -1.25
i 9 a9 @scale 2.5 @offset -1.25
i 10 a10 @scale 2.5 @offset -1.25
i 11 a11 @scale 2.5 @offset -1.25
i 12 a12 @scale 2.5 @offset -1.25
i 13 a13 @scale 2.5 @offset -1.25
i 14 a14 @scale 2.5 @offset -1.25
i 15 a15 @scale 2.5 @offset -1.25
i 16 a16 @scale 2.5 @offset -1.25
i 17 a17 @scale 2.5 @offset -1.25
i 18 a18 @scale 2.5 @offset -1.25
i 19 a19 @scale 2.5 @offset -1.25
i 20 a20 @scale 2.5 @offset -1.25
i 21 a21 @scale 2.5 @offset -1.25
i 22 a22 @scale 2.5 @offset -1.25
i 23 a23 @scale 2.5 @offset -1.25
i 24 a24 @scale 2.5 @offset -1.25
i 25 a25 @scale 2.5 @offset -1.25
i 26 a26 @scale 2.5 @offset -1.25
i 27 a27 @scale 2.5 @offset -1.25
i 28 a28 @scale 2.5 @offset -1.25
i 29 a29 @scale 2.5 @offset -1.25
i 30 a30 @scale 2.5 @offset -1.25
i 31 a31 @scale 2.5 @offset -1.25
i 32 a32 @scale 2.5 @offset -1.25
i 33 a33 @scale 2.5 @offset -1.25
i 34 a34 @scale 2.5 @offset -1.25
i 35 a35 @scale 2.5 @offset -1.25
i 36 a36 @scale 2.5 @offset -1.25
i 37 a37 @scale 2.5 @offset -1.25
i 38 a38 @scale 2.5 @offset -1.25
i 39 a39 @scale 2.5 @offset -1.25
i 40 a40 @scale 2.5 @offset -1.25
i 41 a41 @scale 2.5 @offset -1.25
i 42 a42 @scale 2.5 @offset -1.25
i 43 a43 @scale 2.5 @offset -1.25
i 44 a44 @scale 2.5 @offset -1.25
i 45 a45 @scale 2.5 @offset -1.25
i 46 a46 @scale 2.5 @offset -1.25
i 47 a47 @scale 2.5 @offset -1.25
i 48 a48 @scale 2.5 @offset -1.25
i 49 a49 @scale 2.5 @offset -1.25
i 50 a50 @scale 2.5 @offset -1.25
i 51 a51 @scale 2.5 @offset -1.25
i 52 a52 @scale 2.5 @offset -1.25
i 53 a53 @scale 2.5 @offset -1.25
i 54 a54 @scale 2.5 @offset -1.25
i 55 a55 @scale 2.5 @offset -1.25
i 56 a56 @scale 2.5 @offset -1.25
i 57 a57 @scale 2.5 @offset -1.25
i 58 a58 @scale 2.5 @offset -1.25
i 59 a59 @scale 2.5 @offset -1.25
i 60 a60 @scale 2.5 @offset -1.25
i 61 a61 @scale 2.5 @offset -1.25
i 62 a62 @scale 2.5 @offset -1.25
i 63 a63 @scale 2.5 @offset -1.25
-- stderr --
a.sm:1:1: error: machine 'a' needs 1313 bytes for its image, but the firmware of the atmega328p (Uno) has room for 960 [E0865]
    1 | [state_vector]
      | ^
1 error
-- exit --
0 1 0
