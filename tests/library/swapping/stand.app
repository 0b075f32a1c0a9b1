# A machine that receives its successor as text, between a task that simulates a sensor and one that watches the swap.
[options]
state_vector "stand.sv"
time         time 1 ms
swap         64 KB
swap_trial   1000

[flight]
every 10 ms:
    task    ramp
    machine valve "valve.sm" @bytecode @swap
    task    watch @init
