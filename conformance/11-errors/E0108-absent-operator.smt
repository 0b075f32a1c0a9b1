spec 1.21   There are no operators for powers, remainders and bits.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Hold]
.step
    x = p ** 2      #! E0108 x * x
    x = p ^ 2       #! E0108 x * x
    x = p.^2        #! E0108 x * x
    x = p .* 2      #! E0108 write * alone
    x = p ./ 2      #! E0108 write / alone
    x = p % 2       #! E0108 floor
    x = p << 2      #! E0108 multiply
    x = p >> 2      #! E0108 divide by a power
    x = p > 1 ? 2 : 3   #! E0108 else:
    x = p // 2      #! E0108 floor(a / b)
    p & 4: x = 1    #! E0108 no bits
    p =! 3: x = 1   #! E0108 did you mean '!='?
