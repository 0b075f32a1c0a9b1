spec 5.47   A bool has no range.

-- app.sv --
[R]
bool open @range 0 1      #! E0222 'open' is a bool and cannot have a range
U8 shut @range 0 1
