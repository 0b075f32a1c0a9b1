spec 8.55  Names of files and columns are in quotes, and times have a unit.
expect error

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
F64 y @read_only
bool b @read_only
U8 n @read_only
bool out
F64 seen
[Run]
.step
    out = b
    seen = x + y + n
-- d.csv --
t,P
0,1
-- app.ss --
[options]
delta_t 10
[data]
file d          #! E0771 expected the name of a file in quotes after file
time "t"        #! E0771 expected us, ms, s, min or h
x = P           #! E0771 the name of a column in quotes
missing 0       #! E0771 hold or nan
@compare "P"    #! E0771 name of an element
@compare x "P" tolerance   #! E0771 a number
@compare x "P" delay       #! E0771 a time
[all_states]
true: @stop
