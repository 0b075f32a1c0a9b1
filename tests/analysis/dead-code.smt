spec 6.10   Code that is never executed is reported once, at the outermost statement.
analyses on
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
bool valve
[A]
.step
    q > 5 {
        p > 10: -> B
        p <= 10: -> C
        valve = true                     #! W0512 in every case
        q < 3 { valve = false }
    }
    if p > 10: valve = true
    else if p <= 10: valve = false
    else {
        valve = true                     #! W0513 cover every case
        q > 3: -> D
    }
    p > 3: -> E
[B]
.step
    if p > 3 { -> A } else { -> C }
    valve = true                         #! W0504 both branches
    p > 4 { p > 4: valve = true }
[C]
.exit                                    #! W0514 'C'
    valve = false
[D]
[E]
.entry
    p > 10: -> A
    p <= 10: -> C
.step                                    #! W0505 'E'
    valve = true
