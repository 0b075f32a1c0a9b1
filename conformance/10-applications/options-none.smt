spec 10.1   A state vector is required, where there are no options as well.

-- rocket.app --
[flight]     #! E1030 state_vector "FILE.sv"
every 10 ms:
    task navigation
