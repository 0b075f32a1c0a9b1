# What types decide, in expressions too; a range written out is a habit.
warn decided-comparison no-constant-guard
-- app.sm --
[state_vector]
U64 G
U32 S
U8 n @read_only @alias level
U16 m @read_only
I8 i @read_only
bool b @read_only
F64 p @read_only
bool x
[local]
U16 limit = 300 @read_only
[Hold]
.step
    level > 300: -> Hold              #! W0405 'n' is U8
    n > limit: -> Hold                #! W0405
    n * 1 > 300: -> Hold              #! W0418 'n * 1' is from 0 to 255
    -n > 5: -> Hold                   #! W0418 '-n' is from -255 to 0
    n + m < 0: -> Hold                #! W0418 never
    n + 300 > b: x = true             #! W0418 always
    not (n < 0): x = false            #! W0405
    n < 0 or n > 100: -> Hold         #! W0405
    n >= 0 and p > 3: -> Hold         #! W0406
    x = n >= 0                        #! W0406
    p > 3 and 500 < n < 900: -> Hold  #! W0405
    (p > 3) > 1: -> Hold              #! W0418
    n >= 0 and n <= 100: -> Hold
    0 <= n and n <= 100: -> Hold
    0 <= n <= 100: -> Hold
    n + 10 > 260: -> Hold
    n > m: -> Hold
    i > -128: -> Hold
    p > 1e300: -> Hold
    b == 1: -> Hold
    limit > 200: x = true
    m > limit: -> Hold
