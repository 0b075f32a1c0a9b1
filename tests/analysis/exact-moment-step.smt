# Where it is known how far time advances in a step, T comes to every multiple of that.
warn no-all exact-moment
advance 10
-- app.sm --
[state_vector]
U64  G
U32  S
bool a
[Run]
.step
    T == 500: a = true
    T == 505: a = false                 #! W0408 'T' is possibly never exactly 505
    G == 500: a = true                  #! W0408
