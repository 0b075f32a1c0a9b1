# A window, held and a definition of [all_states] exist once, in however many states and places they are used.
args build --emit=ir -O0 a.sm

-- a.sm --
[options]
step 10 ms

[state_vector]
U64 G
U32 S
F64 p
F64 x

[define]
mean = roll_avg(p, 3)

[all_states] @except Abort
.step
    x = mean + mean
    held(p > 50, 30 ms): -> Abort

[Run] @safe
.step
    mean > 3: -> Wait

[Wait] @safe
.step
    mean > 4: -> Run

[Abort] @safe
-- stdout --
machine "a"
vector "a" size 32 hash 0x192888ca

element U64 G at 0 is G
element U32 S at 8 is S
element F64 p at 16
element F64 x writable at 24
time U64 T
window w0 F64 size 3 stats avg
window w1 U64 size 2 stats elapsed
window w2 U64 size 1 stats run_time

sample {
...
