spec 3.18, 3.42   Elements, locals and states can be named median and average.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 median
F64 average
F64 p

[local]
F64 lowest = 4 @read_only

[Run]
.step
    average = average(median, average, p)
    median = median(median, p, max(p - 6, lowest))
    average > 100: -> average

[average]
.step
    median = 0

-- app.ss --
[options]
delta_t 1

[all_states]
G == 0 {
    median = 3
    average = 5
    p = 10
}
G == 0: @assert average == 6 and median == 4
G == 1: @stop
