spec 10.17   A function that reads or writes a region has a name in C, too.

-- rocket.app --
[options]
state_vector "rocket.sv"
time time 1 ms
[flight]
every 10 ms:
    task rocket_read                  #! E1044 rocket_read_step
    task rocket_write                 #! E1044 rocket_write_step
-- rocket.sv --
[step]
U64  time
F64  altitude
