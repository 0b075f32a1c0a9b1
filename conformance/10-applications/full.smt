spec 10.1, 10.2, 10.3, 10.4, 10.5, 10.6, 10.8, 10.9, 10.10, 10.11, 10.12, 10.14, 10.15, 10.16, 10.17   An application with everything compiles.

-- rocket.app --
[options]
state_vector "rocket.sv"
time         time 1 ms
watchdog     500 ms
events       128
log          "flight.log" 4 KB
keep         "rocket.state"

[start]
mode     = 1 + 1
altitude = -sqrt(2) / 0.5
target   = 1e308 * 10       # infinite

[flight] @priority 80 @overrun catch_up 5 @late late
    @busy busy              # line ends are blanks
every 10 ms:
    task navigation @init
    machine mission "mission.sm" @mode otherMode
    task engine @mode mode @safe
every 0.1 s:
    log
at 2 Hz:
    keep
[slow] @overrun skip
at 0.5 Hz:
    task telemetry @mode mode
-- rocket.sv --
[options]
lock
[A]
U64  time
U32  missionState
F64  altitude
U8   mode
U8   otherMode
U32  late
U32  busy
F64  target
I16  small
-- mission.sm --
[state_vector]
U64  time          @alias G
U32  missionState  @alias S
F64  altitude      @read_only
[Boost]
.step
    altitude > 100: -> Coast
[Coast]
