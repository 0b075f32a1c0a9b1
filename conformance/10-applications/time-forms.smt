spec 10.11, 10.12   Periods and frequencies may be written in every unit, if they are whole nanoseconds.

-- rocket.app --
[options]
state_vector "rocket.sv"
[a]
every 1000 ns:
    task ta
every 2 us:
    task tb
every 0.003 ms:
    task tc
at 250 kHz:
    task td
at 0.125 kHz:
    task te
every 1_000 us:
    task tf
every 3.6e3 s:
    task tg
at 2.5 Hz:
    task th
[b]
at 128 Hz:
    task tj
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
