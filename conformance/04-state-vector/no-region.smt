spec 4.6  A vector without any region is an error.

-- app.sv --
[options]   #! E0604
lock
