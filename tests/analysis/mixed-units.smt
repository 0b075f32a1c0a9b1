# An element without a unit, compared with constants of two units; also through windows.  Not with a number, another unit of the same kind, or in
# different elements.
warn no-all mixed-units

-- app.sm --
[options]
step 10 ms

[state_vector]
U64  time    @alias G
U32  state   @alias S
F32  flow    @read_only
F32  tank    @read_only
bool valve

[define]
leastPressure = 14    @unit bar
mostPressure  = 300   @unit psi
leastFlow     = 0.4   @unit kg/s

[Burn]
.entry
    valve = true
.step
    T > 300 ms and roll_max(flow, 5) < leastPressure: -> Done
    tank > mostPressure: -> Done
    tank < leastPressure: -> Done
    flow < 0.1: -> Done

[Done]
.entry
    valve = false
.step
    leastFlow < flow: -> Burn                                      #! W0453 'flow' is compared with 'leastFlow', which has the unit kg/s
    flow > 3: -> Burn
