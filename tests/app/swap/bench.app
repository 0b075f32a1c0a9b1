# Two machines of which one can be swapped, and a task that swaps it.
[options]
state_vector "bench.sv"
time         time 1 ms
log          "bench.log" 4 KB
swap         8 KB
swap_trial   20
swap_limit   500
armed        armed

[flight]
every 10 ms:
    machine count "count.sm" @bytecode @swap
    task conduct
every 50 ms:
    machine other "other.sm"
    log
