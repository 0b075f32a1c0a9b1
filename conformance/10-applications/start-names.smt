spec 10.8   Elements called like words of an application have values.

-- rocket.app --
[options]
state_vector "rocket.sv"
[start]
time = 1
io = 1
log = 1
keep = 1
watchdog = 1
events = 1
state_vector = 1
every = 1
at = 1
task = 1
machine = 1
inputs = 1
outputs = 1
[flight]
every 10 ms:
    task a
-- rocket.sv --
[A]
U64 time
U8  io
U8  log
U8  keep
U8  watchdog
U8  events
U8  state_vector
U8  every
U8  at
U8  task
U8  machine
U8  inputs
U8  outputs
