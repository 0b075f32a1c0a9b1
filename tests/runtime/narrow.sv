# Nothing in it is wider than a byte.
[Bytes]
U8   one
bool two
