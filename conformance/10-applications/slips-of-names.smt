spec 10.10   A name consists of letters, digits and _; the annotation proposed for an unknown one is allowed there.

-- rocket.app --
[options]
state_vector "rocket.sv"
[flight] @core 1              #! E0360 allowed here: @priority
every 10 ms:
    task tele-metry           #! E0330 letters, digits and _
    task tele_metry
-- rocket.sv --
[options]
lock
[A]
U64  time
U32  missionState
