spec 4.1   A state vector file has no annotations.

-- app.sv --
[A]
F64 a @read_only      #! E0363 '@read_only'
