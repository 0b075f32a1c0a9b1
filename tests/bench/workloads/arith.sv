# Raw readings in, what is made of them out.

[In]
U64   time        # ms
F64   pressure    # kPa
I32   setpoint    # counts
I32   encoder     # counts
F32   airspeed    # m/s
I16   gyroX
I16   gyroY
I16   gyroZ
U16   adc0
U16   adc1
U16   adc2
I8    trim
U8    mode
bool  enable

[Out]
U32   state
F32   volts0
F32   volts1
F32   current
F32   power
F32   celsius
F32   rateX
F32   rateY
F32   rateZ
F32   smooth
F32   lift
F64   energy
F64   kelvin
F64   altitude
F64   integral
F64   command
F64   density
I64   position
I64   balance
U64   ticks
U64   pulses
I32   miss
I32   product
U32   spin
U32   total
U32   minutes
U32   rest
I16   turn
I16   trimmed
I16   mean
U16   slow
U16   high
U16   low
U16   errors
I8    half
I8    direction
I8    tilt
U8    pwm
U8    duty
U8    level
U8    beats
bool  hot
bool  spinning
bool  steady
bool  alarm
bool  brake
