spec 8.6, 8.7   A comparison alone is no item of a script: it checks with @assert.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
[Hold]
.step
    p > 5: -> Hold

-- app.ss --
[options]
delta_t 1
[all_states]
G == 20: S == 2         #! E0327 to check this, write @assert S == 2
G == 30: @stop
