spec 10.9   Rates have a header of their own, which is missed once.

-- rocket.app --
[options]
state_vector "rocket.sv"
every 10 ms:                 #! E1021 write [flight] above it
    task a
    task b
every 20 ms:
    task c
-- rocket.sv --
[A]
U64  time
