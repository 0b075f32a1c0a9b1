spec 1.2   A comment can contain any UTF-8 text.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
# 20 °C ≤ p – “quoted” 日本語 😀
[Hold]
.step
    x = p   # µ
