# What is measured first; the position of the pad changes.

[In]
U64   time        # ms
F32   gyroP       # rad/s
F32   gyroQ
F32   gyroR
F32   airspeed    # m/s
F32   windNorth   # m/s
F32   windEast
F32   padLat      # rad
F32   padLon

[Out]
U32   state
F64   roll        # rad
F64   pitch
F64   yaw
F64   lat
F64   lon
F64   track       # rad, over ground
F64   bearing     # rad, of the pad
F64   distance    # m, to the pad
F32   bank        # rad, wanted
F32   density     # kg/m^3
I16   rudder
U16   rounds
bool  flare
