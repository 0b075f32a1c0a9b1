spec 10.1   A state vector is required.

-- rocket.app --
[options]     #! E0830 needs a state vector
events 8
[flight]
every 10 ms:
    task navigation
