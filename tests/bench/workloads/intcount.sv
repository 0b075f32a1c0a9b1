# The readings first.

[In]
U64   time
I32   encoder     # counts
U16   adc0
U16   adc1
I16   gyro
I8    trim
U8    mode        # 0 ... 3
bool  pulse
bool  fault

[Out]
U32   state
U32   ticks
U32   pulses
U32   travel
U32   energy
I32   balance
I32   error
I32   position
U16   faults
U16   high
U16   quiet
U16   span
I16   turn
I16   drift
I16   rate
U8    debounce
U8    leak
U8    retries
U8    seconds
U8    minutes
I8    score
I8    tilt
I8    bias
bool  alarm
bool  steady
bool  late
