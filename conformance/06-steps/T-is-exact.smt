spec 6.5  T is the exact difference of two times, not of their F64 values: from step to step it grows by exactly delta_t above 2^53.

-- app.sm --
[state_vector]
U64 G
U32 S
U64 n

[A]
.step
    T > 0: -> B
[B]
.step
    n = T

-- app.ss --
[options]
delta_t 9007199254740991

[all_states]
G > 60000000000000000: @stop

-- trace --
1 T 0
2 T 9007199254740991
3 T 0
4 T 9007199254740991
5 T 18014398509481982
6 T 27021597764222973
7 T 36028797018963964
