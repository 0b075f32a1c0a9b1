spec 3.17   Names of other languages, with what to write instead.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool valve
I32 v
[Hold]
.step
    T = 0                           #! E0216 store G and subtract it later
    p(1) > 5: -> Vent               #! E0218 write p alone
    timer(5 s): -> Vent             #! E0217 write T >= 5 s
    rising_edge(valve): -> Vent     #! E0217 write rising(x)
    diff(p) > 3: -> Vent            #! E0217 write x - prev(x)
    p == null: -> Vent              #! E0204 a bool of its own
[Vent]
.entry
