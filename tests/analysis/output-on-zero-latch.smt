# What another sensor has seen long ago.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  speed    @read_only
F32  altitude @read_only
bool main
[local]
bool flew = false
[Flight]
.step
    speed > 50: flew = true
    flew and altitude < 250: -> Main                                    #! W0903 'altitude' alone switches on 'main'
    T > 60000: -> Main
[Main] @safe
.entry
    main = true
.step
    T > 1000: main = false
