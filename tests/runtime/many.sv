# More elements than the VM notes stores of in one word.

[options]
lock

[Many]
U64 G
U32 S
U8 which
U16 e0  U16 e1  U16 e2  U16 e3  U16 e4  U16 e5  U16 e6
U16 e7  U16 e8  U16 e9  U16 e10  U16 e11  U16 e12  U16 e13
U16 e14  U16 e15  U16 e16  U16 e17  U16 e18  U16 e19  U16 e20
U16 e21  U16 e22  U16 e23  U16 e24  U16 e25  U16 e26  U16 e27
U16 e28  U16 e29  U16 e30  U16 e31  U16 e32  U16 e33  U16 e34
U16 e35  U16 e36  U16 e37  U16 e38  U16 e39  U16 e40  U16 e41
U16 e42  U16 e43  U16 e44  U16 e45  U16 e46  U16 e47  U16 e48
U16 e49  U16 e50  U16 e51  U16 e52  U16 e53  U16 e54  U16 e55
U16 e56  U16 e57  U16 e58  U16 e59  U16 e60  U16 e61  U16 e62
U16 e63  U16 e64  U16 e65  U16 e66  U16 e67  U16 e68  U16 e69
