spec 5.35  Sixty branches one after another.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x

[Run]
.step
    if a == 0: x = 0
    else if a == 1: x = 1
    else if a == 2: x = 4
    else if a == 3: x = 9
    else if a == 4: x = 16
    else if a == 5: x = 25
    else if a == 6: x = 36
    else if a == 7: x = 49
    else if a == 8: x = 64
    else if a == 9: x = 81
    else if a == 10: x = 100
    else if a == 11: x = 121
    else if a == 12: x = 144
    else if a == 13: x = 169
    else if a == 14: x = 196
    else if a == 15: x = 225
    else if a == 16: x = 256
    else if a == 17: x = 289
    else if a == 18: x = 324
    else if a == 19: x = 361
    else if a == 20: x = 400
    else if a == 21: x = 441
    else if a == 22: x = 484
    else if a == 23: x = 529
    else if a == 24: x = 576
    else if a == 25: x = 625
    else if a == 26: x = 676
    else if a == 27: x = 729
    else if a == 28: x = 784
    else if a == 29: x = 841
    else if a == 30: x = 900
    else if a == 31: x = 961
    else if a == 32: x = 1024
    else if a == 33: x = 1089
    else if a == 34: x = 1156
    else if a == 35: x = 1225
    else if a == 36: x = 1296
    else if a == 37: x = 1369
    else if a == 38: x = 1444
    else if a == 39: x = 1521
    else if a == 40: x = 1600
    else if a == 41: x = 1681
    else if a == 42: x = 1764
    else if a == 43: x = 1849
    else if a == 44: x = 1936
    else if a == 45: x = 2025
    else if a == 46: x = 2116
    else if a == 47: x = 2209
    else if a == 48: x = 2304
    else if a == 49: x = 2401
    else if a == 50: x = 2500
    else if a == 51: x = 2601
    else if a == 52: x = 2704
    else if a == 53: x = 2809
    else if a == 54: x = 2916
    else if a == 55: x = 3025
    else if a == 56: x = 3136
    else if a == 57: x = 3249
    else if a == 58: x = 3364
    else if a == 59: x = 3481
    else: x = -1

-- app.ss --
[options]
delta_t 1

[all_states]
true: a = G
G == 31: @assert x == 961
G == 59: @assert x == 3481
G == 60: @assert x == -1
G == 60: @stop
