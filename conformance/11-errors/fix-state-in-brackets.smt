spec 5.9   A transition names its state without brackets; the edit removes them.

-- app.sm --
[state_vector]
U64 G
U32 S
[Hold]
.step
    T > 5: -> [Idle]   #! E0323
[Idle]
