spec 1.23   A section name consists of letters, digits, _ and /.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
F64 p
[Tank Vent]     #! E0120 write [Tank_Vent]
.step
    x = p
[Vent-Fast]     #! E0120 write [Vent_Fast]
[ Hold ]        #! E0120 write [Hold]
[a+b]           #! E0120 write letters, digits and _ only
[]              #! E0120 '[]'
