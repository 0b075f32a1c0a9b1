spec 1.21   What users of other languages write is reported once, with what to write instead.

-- app.sm --
[options]
step 10 ms
[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  x      @read_only
bool c      @read_only
bool v
[local]
U32 k = 0
enum Mode {A, B}                    #! E0329 each on a line: A = 0, B = 1
enum Phase { Boost = 3,             #! E0329 each on a line: Boost = 3, Coast = 4
    Coast }
struct Tank { U32 level; };         #! E0329 declare each value on its own
i : INT := 7;                       #! E0352 write I32 i = 7
let low = 3                         #! E0329 write a type, as in F64 low = 3
def high = 4                        #! E0329 a line high = 4 in a section [define]
timer t1                            #! E0351
U32 a 3                             #! E0355 write U32 a = 3
U32 b = 1, d = 2                    #! E0357 each on a line of its own
[Idle]
.step
    v = true for 1 s                #! E0330 'v = true' in .entry, 'T >= 1 s: -> NEXT' in .step
    after 2 s: -> Tank_Vent         #! E0762 write T >= 2 s
    from 1 s to 4 s: v = true       #! E0762 write 1 s <= T < 4 s
    every 1 s: v = not v            #! E0762 T >= 1 s: -> NEXT
    T between 1 s and 4 s: v = true #! E0328 write 1 s <= T <= 4 s
    x in 3..5: v = true             #! E0115 write 3 <= x <= 5
    -> Tank Vent                    #! E0330 write Tank_Vent
    x > 50%: v = true               #! E0108 write a percentage as a factor
    x > 50 % and c: v = true        #! E0108 write a percentage as a factor
    x > 5 → Tank_Vent               #! E0102 write : ->
    TON(IN := c, PT := T#2s)        #! E0108 write held(c, 2 s)
    c for 2 s: v = true             #! E0328 write held(c, 2 s)
    c ? v = true : v = false        #! E0108 write it as if
    for i in 1..3: v = true         #! E0329 there are no loops
    toggle v                        #! E0328 write v = not v
    close v                         #! E0328 write v = false
    k mod 2 == 0: v = true          #! E0328 write k - 2 * floor(k / 2)
    state Tank_Vent: v = true       #! E0328 write S == Tank_Vent
    c and then -> Tank_Vent         #! E0330 write ':' instead of 'and then'
    on c: -> Tank_Vent              #! E0329 write if
    next Tank_Vent                  #! E0329 write ->
    default: v = true               #! E0329 write else
    always: v = true                #! E0204 did you mean 'true'?
    v = high_enough                 #! E0204
    time_in_state > 2 s: v = true   #! E0204 did you mean 'T'?
    debounce(c, 30 ms): v = true    #! E0217 held(x > 5, 500 ms)
    rise(c): v = true               #! E0217 write rising(x)
    mean(x, 5) > 3: v = true        #! E0217 average(a, b) for several values
    switch (k) {                    #! E0329 write it as if k == 1
    case 1: v = true
    case 2: v = false
    default: v = true
    }
[Tank_Vent]

