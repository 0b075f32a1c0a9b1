spec 1.23  A section name can contain letters, digits, _ and /, in any order.

-- app.sv --
[9/a_B]
F64 x
[/]
F64 y
[_]
F64 z
[42]
F64 w
