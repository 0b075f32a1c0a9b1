# Overwritten on all ways before anything reads it: within a step for elements, over states for locals.
warn dead-store
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
bool pump
bool lamp
bool horn
F64 shown
F64 twice
F64 out
F64 heat
[local]
F64 mean = 0
F64 held = 0
F64 old = 0
U64 start = 0
U32 count = 0
F64 duty = 0
U32 loops = 0
[Fill]
.entry
    valve = false             #! W0410 'valve'
    pump = false
    start = G                 #! W0410 'start'
    heat = 0
    duty = 0                  #! W0410 'duty'
    count = 0
.step
    valve = p > 5
    p > 7: pump = true
    lamp = false
    p > 8: lamp = true
    horn = true               #! W0410 'horn'
    p > 9: horn = false
    else: horn = p > 1
    twice = 1                 #! W0410
    twice = 2
    out = p
    shown = out
    out = 0
    mean = p
    shown = mean + shown
    mean = 0                  #! W0410 'mean'
    count = count + 1
    count > 100: -> Run
    duty = p * 2
    heat = duty
    old = held
    held = p
    shown = shown + old
    loops = loops + 1
.exit
    loops = loops * 2
    heat = 0
    lamp = true               #! W0410 'lamp'
    lamp = loops > 5
[Run]
.entry
    start = G
    loops = 0
.step
    valve = true
    G - start > 500: -> Fill
    p > 5 {
        valve = false         #! W0410 'valve'
        -> Fill
    }
.exit
    valve = false
