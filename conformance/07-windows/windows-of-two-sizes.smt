spec 7.9  Windows of one size and of another in one machine: each counts its own slots.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
F64 q
F64 least
F64 most
F64 middle
F64 avg

[Run]
.step
    least = roll_min(p, 2)
    most = roll_max(p, 3)
    middle = roll_median(q, 3)
    avg = roll_avg(q, 2)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0: p = 1
G == 1: p = 5
G == 2: p = 3
G == 3: p = 2
G == 4: p = 4
G == 5: p = 0
G == 0: q = 10
G == 1: q = 20
G == 2: q = 60
G == 3: q = 30
G == 4: q = 20
G == 5: q = 0
G == 0: @assert least == 1 and most == 1 and middle == 10 and avg == 10
G == 1: @assert least == 1 and most == 5 and middle == 15 and avg == 15
G == 2: @assert least == 3 and most == 5 and middle == 20 and avg == 40
G == 3: @assert least == 2 and most == 5 and middle == 30 and avg == 45
G == 4: @assert least == 2 and most == 4 and middle == 30 and avg == 25
G == 5: @assert least == 0 and most == 4 and middle == 20 and avg == 10
G == 5: @stop
