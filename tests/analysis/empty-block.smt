spec 5.26   Labels with no statement behind them, where untidiness is asked for.
warn empty-block
-- app.sm --
[state_vector]
U64 G
U32 S
F64 p
[A]
.entry                                   #! W0516 .entry of 'A' is empty
.step
    p > 3: -> B
.exit                                    #! W0516
[B]
