spec 4.14  @read_only, @alias and the marks of states belong to a machine.

-- app.sv --
[R]
F64 a @read_only          #! E0363 '@read_only'
F64 b @alias c            #! E0363 '@alias'
F64 d @range 0 1
F64 e @safe               #! E0375 [Name] @safe
F64 f @range 1            #! E0377 the highest value
F64 h @command
F64 g
