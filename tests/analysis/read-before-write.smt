# Boost reads `start`, which only Coast writes.
warn read-before-write no-constant-guard no-dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 altitude @read_only
bool chute
F64 shown
F64 shown2
[local]
U64 start   = 0
F64 ground  = 0
F64 level   = 0
F64 peak    = 0
F64 limit   = 100
U8 mode     = 2
bool armed  = false
U32 count   = 0
U32 phase   = 0
F64 before  = 0
F64 after   = 0
[Boost]
.step
    G - start > 5000: -> Coast                #! W0208 'start' is still 0 here: it is first assigned later, in state 'Coast'
    altitude - ground > 50: -> Coast          #! W0208 'ground' is still 0
    altitude > limit: -> Coast
    mode > 3 and altitude > 5: -> Coast       #! W0208 'mode' is still 2 here
    armed: chute = true                       #! W0208 'armed' is still false
    shown = phase
    before = altitude
    altitude > peak: peak = altitude
    count = count + 1
    shown2 = level * 2                        #! W0208 in state 'Boost'
.exit
    level = altitude
[Coast]
.entry
    start = G
    ground = altitude
    limit = 200
    mode = 5
    armed = true
    phase = 1
    count = count + 1
.step
    before - after > 3: -> Land
    after = before
    mode > 3 and armed: shown = 2
    chute = altitude < peak and altitude < limit and altitude - ground > 3 and G > start and count > 2
    shown2 = level
[Land]
