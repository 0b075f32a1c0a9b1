spec 5.30   Guards that others explain, that are switches, that say what is left over, or that can go both ways.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool valve
bool cmd
U8 level
[local]
bool bench = false @read_only
U8 mode = 0
U8 limit = 3 @read_only
U8 count = 0
[A]
.step
    true: valve = true
    bench: -> Bench
    bench and p > 3 { valve = false }
    not bench or p > 3: valve = true
    limit + 1 > 2: valve = false
    level > 300: valve = true            #! W0405
    p > 10: valve = true
    else if p <= 10: valve = false
    p > 20 or p < 10: valve = true
    p < 20 and p > 10: valve = false
    p > 10: -> B
    p <= 10 and q > 3: -> B
    count = count + 1
    count > 200: -> C
[B]
.step
    p < 5: -> A
    p > 10: -> C
    5 <= p <= 10: -> A
[C]
.step
    mode == 1: -> A
    valve: mode = 2
    cmd: mode = 1
    p > 0 and not (p > 5): -> B
[Bench]
.step
    p / q > 3 or p / q <= 3: -> A        # 0/0 is neither
