# A stand where two pressure sensors abort together: while one sticks, the other one still does.
warn no-all abort-blind abort-single-sensor

-- app.sm --
# Test stand "Bertha": hybrid engine, nitrous oxide on a paraffin grain. The tank is filled on the stand from
# a bottle, topped up with nitrogen, and emptied through the engine.
#   Idle -> Charge -> LeakCheck -> Purge -> Fill (<-> Relief) -> Pressurise -> Armed -> Ignition -> Burn
#        -> Shutdown -> Vent -> Idle              Everything may end in Abort. Pressures are absolute.

[options]
step 10 ms

[state_vector]
U64   time           @alias G
U32   state          @alias S
F32   tankPressureA  @read_only @range 0.5 100  @unit bar
F32   tankPressureB  @read_only @range 0.5 100  @unit bar
F32   chamber        @read_only @range 0.5 60   @unit bar
F32   oxTemperature  @read_only @range 250 330  @unit K     # thermocouple on the tank wall
F32   oxMass         @read_only @range -0.5 20  @unit kg    # load cell under the tank, tare removed
bool  continuity     @read_only                             # current flows through the igniter's bridge wire
bool  abortButton    @read_only @command
U8    order          @read_only @command                    # 0 none, 1 start, 2 fire, 3 vent, 4 reset
bool  fillValve
bool  pressValve                                            # nitrogen into the tank
bool  mainValve                                             # oxidizer into the engine
bool  ventValve                                             # tank to the open air
bool  purgeValve                                            # nitrogen through feed line and chamber
bool  igniter
bool  siren

[local]
F32  leakStart   = 0      @unit bar
bool sensorFault = false

[define]
start        = order == 1
fire         = order == 2
vent         = order == 3
reset        = order == 4
emptyTank    = 2    @unit bar
tank         = average(tankPressureA, tankPressureB)
highest      = max(tankPressureA, tankPressureB)
disagree     = held(abs(tankPressureA - tankPressureB) > 3, 200 ms)
tooHot       = held(not (250 < oxTemperature < 308), 200 ms)
overpressure = held(chamber > 35, 20 ms)

[all_states]
.step siren = S == Pressurise or S == Armed or S == Ignition or S == Burn

# Ignition and Burn are fast, and check everything themselves.
[all_states] @except Idle Ignition Burn Abort
.step held(abortButton, 50 ms): -> Abort

[all_states] @except Idle Abort
.step
    disagree: sensorFault = true
    held(highest >= 60, 50 ms): -> Abort

[all_states] @except Idle Charge LeakCheck Purge Fill Relief Shutdown Vent Abort
.step sensorFault: -> Abort

[all_states] @except Idle Charge LeakCheck Purge Ignition Burn Shutdown Vent Abort
.step tooHot: -> Abort

[Idle] @safe
.entry
    fillValve  = false
    pressValve = false
    mainValve  = false
    ventValve  = false
    purgeValve = false
    igniter    = false
.step
    reset: sensorFault = false
    start and not (abortButton or sensorFault) and highest < emptyTank and chamber < 2 and oxMass < 0.5: -> Charge

[Charge]
.entry pressValve = true
.step
    vent: -> Vent
    tank >= 10: -> LeakCheck
    T >= 10 s: -> Abort
.exit pressValve = false

[LeakCheck]
.entry leakStart = tank
.step
    vent: -> Vent
    T >= 5 s {
        leakStart - tank > 0.5: -> Abort
        -> Purge
    }

[Purge]
.entry
    purgeValve = true
    ventValve  = true
.step
    vent: -> Vent
    T >= 3 s and highest < emptyTank: -> Fill
    T >= 20 s: -> Abort
.exit
    purgeValve = false
    ventValve  = false

[Fill]
.entry
    fillValve   = true
    sensorFault = false
.step
    vent: -> Vent
    highest > 55: -> Relief
    oxMass > 9: -> Abort
    oxMass >= 8 {
        sensorFault: -> Vent
        -> Pressurise
    }
    T >= 60 s: -> Abort
.exit fillValve = false

[Relief]
.entry ventValve = true
.step
    vent: -> Vent
    highest < 50: -> Fill
    T >= 10 s: -> Abort
.exit ventValve = false

[Pressurise]
.entry pressValve = true
.step
    vent: -> Vent
    tank >= 52 {
        pressValve = false
        -> Armed
    }
    T >= 15 s: -> Abort

[Armed]
.step
    held(not continuity, 100 ms): -> Abort
    vent or T >= 120 s: -> Vent
    T >= 3 s and rising(fire) and continuity and chamber < 2: -> Ignition

[Ignition]
.entry igniter = true
.step
    overpressure: -> Abort
    T >= 500 ms: mainValve = true
    T > 500 ms and chamber >= 8: -> Burn
    T >= 1.5 s: -> Abort
.exit igniter = false

[Burn]
.step
    abortButton: -> Abort
    overpressure: -> Abort
    T > 300 ms and held(chamber < 10, 100 ms): -> Abort
    T >= 6 s: -> Shutdown
.exit mainValve = false

[Shutdown]
.entry purgeValve = true
.step T >= 5 s: -> Vent
.exit purgeValve = false

[Vent]
.entry ventValve = true
.step
    T >= 5 s and highest < emptyTank: -> Idle
    T >= 120 s: -> Abort

[Abort] @abort @safe
.entry
    fillValve  = false
    pressValve = false
    mainValve  = false
    igniter    = false
    ventValve  = true
    purgeValve = true
.step
    T >= 10 s: purgeValve = false
    T >= 10 s and reset and highest < emptyTank and not abortButton: -> Idle
