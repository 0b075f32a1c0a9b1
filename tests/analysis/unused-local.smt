# Locals that only themselves or each other need.  Counters, filters and latches that other code reads are silent.
warn unused-local no-constant-guard
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
F64 out
[local]
U32 count = 0                 #! W0206 'count'
U32 alone = 0                 #! W0206 'alone'
U32 ping = 0                  #! W0206 'ping'
U32 pong = 0                  #! W0206 'pong'
U32 seen = 0                  #! W0205 'seen'
U32 idle = 0                  #! W0204 'idle'
U32 steps = 0
F64 filtered = 0
bool latched = false
F64 fed = 0
U16 n = 5
[Hold]
.step
    count = count + 1
    p > 5 {
        alone > 100: alone = 0
        alone = alone + 1
    }
    ping = pong + 1
    pong = ping
    seen = steps
    steps = steps + 1
    filtered = filtered + (p - filtered) / 8
    valve = filtered > 100
    not latched and p > 50: latched = true
    latched: out = 1
    fed = roll_max(p, n)                      #! W0402 'n'
    n = n + 1
    steps > 1000 or fed > 3: -> Hold
