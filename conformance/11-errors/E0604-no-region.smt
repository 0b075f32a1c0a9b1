spec 4.6   A state vector without a region is an error.
-- app.sv --
[options]                     #! E0604
lock
