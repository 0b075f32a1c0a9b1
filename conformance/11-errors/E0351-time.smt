spec 2.1   A value without a type causes no further error.

-- app.sm --
[state_vector]
uint64_t time  @alias G     #! E0351 did you mean 'U64'?
uint32_t state @alias S     #! E0351 did you mean 'U32'?
F64 p
[Hold]
.step
    p > 5: p = 0
