spec 10.1   A state vector is required.

-- rocket.app --
[options]     #! E1030 needs a state vector
events 8
[flight]
every 10 ms:
    task navigation
