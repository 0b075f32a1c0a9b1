[options]
delta_t 1
[all_states]
G == 0 { x = 0.1
 y = 10
 z = -1
 f = 1e-42
 wide = 9007199254740993
 firstOfTwo = 10
 secondOfTwo = 20
 uwide = 9223372036854776833 }
G > 0 { x = x * 1.7 - y / 3 + 0.1
 y = (y - z) * 0.9 + 1 / x
 z = -z / 3 + x * y - 0.5
 f = f * 3 + x * 1e-44
 wide = wide * 3 + 1
 uwide = uwide - 1025 }
G == 200: @stop
