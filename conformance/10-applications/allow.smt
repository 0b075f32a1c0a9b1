spec 10.20  @allow after an option, a header or a task covers the line, or the executor; an unused @allow is a warning.
warn flight

-- rocket.app --
[options]
state_vector "rocket.sv"
time         time 1 ms
log          "flight.log" 4 KB @allow(option-without-task, "the ground turns it on in the next version")
keep         "rocket.state" #! W1040 'keep' is in [options], but 'keep' is a task of no executor
[flight]
every 10 ms:
    task    engine    @mode mode @allow(mode-without-safe, "its valves shut by a spring")
    task    parachute @mode mode                                #! W1045 'parachute' has a mode and no @safe
    task    horn      @allow(mode-without-safe, "it is quiet")  #! W0210 unused '@allow(mode-without-safe)': no warning needs it here
    machine phase     "phase.sm"
[slow] @allow(mode-without-safe, "nothing in here moves")
every 1 s:
    task    lamps     @mode mode
    task    telemetry @mode mode
-- rocket.sv --
[A]
U64  time
U32  phaseState
U8   mode

[options]
lock
-- phase.sm --
[state_vector]
U64  time          @alias G
U32  phaseState    @alias S
[A]
.step
    T > 100: -> B
[B] @safe
