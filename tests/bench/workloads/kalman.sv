# What the sensors measure first, with their variances.

[In]
U64   time        # ms
F64   accel       # m/s^2, gravity removed
F64   baro        # m
F64   baroVar     # m^2
F64   gps         # m
F64   gpsVar      # m^2
bool  fix         # `gps` is new

[Out]
U32   state
F64   height      # m
F64   speed       # m/s
F64   bias        # m/s^2
F64   sigma       # m, of the height
F64   nis         # normalised innovation squared
U16   rejected
bool  drogue
