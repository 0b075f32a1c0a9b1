# A state that is left at once by the condition that led into it, and those that are not.
warn no-all cascade

-- app.sm --
[state_vector]
U64 G
U32 S
F32 alt @read_only
F32 q @read_only
bool cmd @read_only
bool armed @read_only
[local]
F64 top = 0
[Climb]
.step
    alt > 1000: -> Coast
    T > 100: -> Sum
[Coast]
.step
    alt > 500: -> Fall                  #! W0925 'Coast' is left at once: the condition that led into it (alt > 1000) also ends it
    T > 10: -> Climb
[Fall]
.step
    alt < 300: -> Flag                  # another height
[Flag]
.step
    cmd and armed: -> Both
    T > 10: -> Late
[Both]
.step
    armed: -> Once                      # a common name can be shared by several states
[Once]                                  # on purpose
.step
    -> Late
[Late]
.step
    cmd: -> Wait
[Wait]
.step
    cmd and T > 10: -> Other            # time in the state
[Other]
.step
    cmd and armed: -> Climb             # more than what led here
[Sum]
.step
    alt > q + 50: -> High
[High]
.entry
    top = alt
.step
    top - q > 20: -> Climb              #! W0925
    alt < q: -> Low
[Low]
.step
    alt < q - 10: -> Climb
