spec 5.50, 5.51, 5.68  An @allow after [all_states] covers the section, and one before a statement each of its copies.
analyses on

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x @read_only
U8  n
[all_states] @allow(empty-braces, "later") @allow(all-states-skipped, "known")
.step
    x > 1 { }
    n = 300                          #! W0403
[all_states]
.step                                #! W0518
    @allow(empty-braces, "later")
    x > 2 { }
    x > 3 { }                        #! W0502
[all_states] @allow(dead-store, "without need")     #! W0210
.step                                #! W0518
    x > 9: n = 2
[A]
.entry
    x > 9: -> B
[B]
.step
    x > 1 { }                        #! W0502
    T > 3: -> A
