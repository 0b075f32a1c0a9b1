spec 4.1  Elements of a state vector bear no annotations: those belong to a machine.

-- app.sv --
[R]
F64 a @read_only   #! E0363
