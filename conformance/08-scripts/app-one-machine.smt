spec 8.78, 8.79   In the script of one machine, names stand alone.
expect error

-- app.sm --
[state_vector]
U64  time   @alias G
U32  aState @alias S
F64  pressure @read_only
bool ready
U32  aSteps

[local]
U32 seen = 0

[Wait] @safe
.step
    aSteps = aSteps + 1
    seen = seen + 1
    pressure > 10: -> Go

[Go] @safe
.step
    aSteps = aSteps + 1
    ready = true
    seen > 1000: -> Wait
-- app.ss --
[options]
delta_t 10
[all_states]
a.T == 0: pressure = 11           #! E0791 write T
app.seen == 0: pressure = 11      #! E0791 write seen
a.nosuch == 0: pressure = 11      #! E0791
G == 100: @stop
[a.Wait]                          #! E0791 write Wait
G == 1: pressure = 1
