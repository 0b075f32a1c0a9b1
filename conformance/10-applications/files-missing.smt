spec 10.1, 10.2, 10.15   A file that cannot be read is an error where it is named.

-- rocket.app --
[options]
state_vector "nosuch.sv"     #! E1031 nosuch.sv
time time 1 ms
[flight]
every 10 ms:
    machine mission "gone.sm"     #! E1031 gone.sm
