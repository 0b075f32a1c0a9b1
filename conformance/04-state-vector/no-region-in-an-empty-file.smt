spec 4.6  An empty file is no state vector.

-- app.sv --
# nothing here   #! E0604
