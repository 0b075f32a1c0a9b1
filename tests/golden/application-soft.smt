# An application for a chip whose double is no binary64: its vector and its machines agree on what a number is.
args build a.app --soft && grep -n 'F64' *.h | grep -v '^a_'

-- v.sv --
[options]
lock
[A]
U64 time
U32 stateOfM
F64 altitude
-- m.sm --
[state_vector]
U64 time     @alias G
U32 stateOfM @alias S
F64 altitude
[Pad]
.step
    altitude > 100: -> Flight
[Flight] @safe
-- a.app --
[options]
state_vector "v.sv"
time         time 1 ms
[flight]
every 10 ms:
    machine m "m.sm"
-- stdout --
m.h:25:    SmF64    altitude;
v.h:25:    SmF64    altitude;
v.h:90:static inline SmF64 v_altitude(void)
v.h:92:    SmF64 value = sm_from_i32(0);
v.h:100:static inline void v_set_altitude(SmF64 value)
